// Contacts from substep to substep, against a set of keys, and impacts against the impulses that make them.
#include "physics/dynamics/engines/substepped/touch_record.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>
#include <set>

namespace trembler {
namespace touch_record_test {
namespace {

constexpr auto neverRests = [](PieceContact const&) { return false; };

PieceContact contact(SlotIndex a, SlotIndex b, std::size_t piece = 0, double impulse = 0) {
    PieceContact made;
    made.key = pieceKey(pieceName(a, piece), pieceName(b, 0));
    made.slotA = a;
    made.slotB = b;
    made.patch.a = {a, 0};
    made.patch.b = {b, 0};
    made.patch.normal = {0, 1};
    made.patch.count = 1;
    made.patch.points[0] = {static_cast<double>(piece), 5};
    made.patch.normalImpulse[0] = impulse;
    return made;
}

TEST(TouchRecord, PiecesKeepTheirKeysInEitherOrder) {
    std::set<std::uint64_t> keys;
    for (SlotIndex slot = 0; slot < 5; ++slot) {
        for (std::size_t piece = 0; piece < 768;
             piece += 255) { // up to three shapes of the engine for each of 256 pieces
            std::uint32_t const name = pieceName(slot, piece);
            EXPECT_EQ(slotOfPiece(name), slot);
            std::uint32_t const other = pieceName(7, 3);
            EXPECT_EQ(pieceKey(name, other), pieceKey(other, name));
            EXPECT_TRUE(keys.insert(pieceKey(name, other)).second);
        }
    }
}

TEST(TouchRecord, ReportsEveryBeginningAndEveryEndOnce) {
    EXPECT_TRUE(rc::check("the same as a set", [] {
        TouchRecord record;
        std::map<std::uint64_t, PieceContact> model;
        for (int substep = *rc::gen::inRange(1, 10); substep > 0; --substep) {
            SlotIndex const resting = *rc::gen::inRange(0U, 5U); // asleep, so it is not searched
            std::vector<PieceContact> found;
            std::map<std::uint64_t, PieceContact> next;
            for (int i = *rc::gen::inRange(0, 12); i > 0; --i) {
                auto const a = *rc::gen::inRange<SlotIndex>(0, 4);
                auto const b = *rc::gen::inRange<SlotIndex>(a + 1, 6);
                PieceContact const one = contact(a, b, *rc::gen::inRange<std::size_t>(0, 2));
                if (a != resting && next.emplace(one.key, one).second) {
                    found.push_back(one);
                }
            }
            std::map<std::pair<ObjectId, ObjectId>, int> expected;
            for (auto const& [key, one] : next) {
                expected[{one.patch.a, one.patch.b}] += model.contains(key) ? 0 : 1;
            }
            for (auto const& [key, one] : model) {
                if (one.slotA == resting) {
                    next.emplace(key, one);
                } else if (!next.contains(key)) {
                    --expected[{one.patch.a, one.patch.b}];
                }
            }
            record.changes().clear();
            record.take(found, [&](PieceContact const& one) { return one.slotA == resting; });
            RC_ASSERT(found.empty());
            std::map<std::pair<ObjectId, ObjectId>, int> reported;
            for (TouchChange const& change : record.changes()) {
                reported[{change.a, change.b}] += change.delta;
            }
            std::erase_if(expected, [](auto const& entry) { return entry.second == 0; });
            std::erase_if(reported, [](auto const& entry) { return entry.second == 0; });
            RC_ASSERT(reported == expected);
            model = next;
            RC_ASSERT(record.contacts().size() == model.size());
            auto at = model.begin();
            for (PieceContact const& one : record.contacts()) { // ascending by key
                RC_ASSERT(one.key == (at++)->first);
            }
        }
    }));
}

TEST(TouchRecord, RemovingABodyEndsItsContacts) {
    TouchRecord record;
    std::vector<PieceContact> found{contact(0, 1), contact(1, 2), contact(0, 2), contact(1, 2, 1)};
    record.take(found, neverRests);
    record.changes().clear();
    record.remove(1);
    EXPECT_EQ(record.contacts().size(), 1U);
    EXPECT_EQ(record.changes().size(), 3U);
    for (TouchChange const& change : record.changes()) {
        EXPECT_EQ(change.delta, -1);
        EXPECT_TRUE(change.a == (ObjectId{1, 0}) || change.b == (ObjectId{1, 0}));
    }
}

// Bodies of 1 kg that do not turn and approach each other at `speed` along the normal of contact().
TouchRecord::ImpactScene oneKilogramEach(double speed = 1e3) {
    TouchRecord::ImpactScene scene;
    scene.slots = 3;
    scene.before = [speed](SlotIndex slot) {
        return ImpactBudget::Body{.inverseMass = 1, .centre = {}, .velocity = {0, slot == 0 ? speed : 0}};
    };
    scene.lost = [](SlotIndex) { return 0.0; };
    return scene;
}

TEST(TouchRecord, AnImpactIsAnIncreaseOfTheImpulse) {
    TouchRecord record;
    record.noteImpacts(true);
    auto const substep = [&](double impulse, double since) {
        std::vector<PieceContact> found{contact(0, 1, 0, impulse)};
        record.take(found, neverRests);
        record.startStep();
        record.findImpacts(since, oneKilogramEach());
    };
    substep(3, 0.25);
    ASSERT_EQ(record.impacts().size(), 1U);
    EXPECT_EQ(record.impacts()[0].impulse, 3);
    EXPECT_EQ(record.impacts()[0].point, (Vec2{0, 5}));
    substep(3, 0.5);
    EXPECT_TRUE(record.impacts().empty()) << "the force is as before";
    substep(1, 0.5);
    EXPECT_TRUE(record.impacts().empty());
    substep(4, 0.5);
    ASSERT_EQ(record.impacts().size(), 1U);
    EXPECT_NEAR(record.impacts()[0].impulse, 4 - 0.8 * 3, 1e-12) << "less the remembered share of 3 N s";
    substep(4 + 0.4 * faintestImpact, 0.5);
    EXPECT_TRUE(record.impacts().empty())
        << "too weak: the relative speed of two bodies of 1 kg changes by twice the impulse";
    substep(5 + faintestImpact, 0.5);
    EXPECT_EQ(record.impacts().size(), 1U);
}

TEST(TouchRecord, ContactsFromBeforeTheFirstRequestAreNoImpacts) {
    TouchRecord record;
    std::vector<PieceContact> found{contact(0, 1, 0, 9)};
    record.take(found, neverRests);
    record.noteImpacts(true);
    record.findImpacts(0, oneKilogramEach());
    EXPECT_TRUE(record.impacts().empty()) << "the force may have existed before";
    found = {contact(0, 1, 0, 20)};
    record.take(found, neverRests);
    record.findImpacts(0, oneKilogramEach());
    EXPECT_LE(record.impacts().size(), 1U);
    record.noteImpacts(false);
    EXPECT_TRUE(record.impacts().empty());
    found = {contact(0, 1, 0, 90)};
    record.take(found, neverRests);
    record.findImpacts(0, oneKilogramEach());
    EXPECT_TRUE(record.impacts().empty()) << "impacts are not requested";
}

TEST(TouchRecord, AnImpactIsAtTheWeightedMeanOfItsPoints) {
    TouchRecord record;
    record.noteImpacts(true);
    PieceContact edge = contact(0, 1);
    edge.patch.count = 2;
    edge.patch.points = {Vec2{0, 0}, Vec2{4, 0}};
    edge.patch.normalImpulse = {3, 1};
    std::vector<PieceContact> found{edge};
    record.take(found, neverRests);
    record.findImpacts(0.125, oneKilogramEach());
    ASSERT_EQ(record.impacts().size(), 1U);
    EXPECT_EQ(record.impacts()[0].point, (Vec2{1, 0}));
    EXPECT_EQ(record.impacts()[0].impulse, 4);
}

TEST(TouchRecord, AnImpulseWithoutMotionIsPressure) {
    for (double const speed : {0.0, -2.0, 0.25}) { // at rest, separating, approaching slowly
        TouchRecord record;
        record.noteImpacts(true);
        std::vector<PieceContact> found{contact(0, 1, 0, 3)};
        record.take(found, neverRests);
        record.findImpacts(0, oneKilogramEach(speed));
        if (speed <= 0) {
            EXPECT_TRUE(record.impacts().empty()) << speed;
        } else {
            ASSERT_EQ(record.impacts().size(), 1U);
            // The reduced mass is 0.5 kg; reversing the motion takes 2 * 0.5 kg * 0.25 m/s.
            EXPECT_NEAR(record.impacts()[0].impulse, 0.25, 1e-12);
        }
    }
}

} // namespace
} // namespace touch_record_test
} // namespace trembler
