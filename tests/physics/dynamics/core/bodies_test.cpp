// The bodies of an engine follow the columns: which are added, in which order, which are refused and why, and
// which changes make a body out of date.
#include "physics/dynamics/core/bodies.hpp"
#include "tests/physics/dynamics/core/hand_columns.hpp"
#include "tests/physics/dynamics/core/recording_engine.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <functional>
#include <set>

namespace trembler::test {
namespace bodies_test {
namespace {

std::vector<Refusal> add(BodyTable& bodies, HandColumns const& columns, RecordingEngine& engine) {
    std::vector<Refusal> refusals;
    bodies.addMissing(columns.view(), engine, refusals);
    return refusals;
}

TEST(BodyTable, AddsBodiesInOrderOfObjectsWhateverTheOrderOfWriting) {
    EXPECT_TRUE(rc::check("ascending", [] {
        HandColumns columns;
        std::set<ObjectId> all;
        for (std::uint32_t const index :
             *rc::gen::container<std::vector<std::uint32_t>>(rc::gen::inRange<std::uint32_t>(0, 20))) {
            all.insert(columns.body(index));
        }
        BodyTable bodies;
        RecordingEngine engine;
        RC_ASSERT(add(bodies, columns, engine).empty());
        RC_ASSERT(engine.added == std::vector<ObjectId>(all.begin(), all.end()));
        RC_ASSERT(add(bodies, columns, engine).empty());
        RC_ASSERT(engine.added.size() == all.size()); // each once
        RC_ASSERT(bodies.outdated(columns.view()).empty());
        for (ObjectId const id : all) {
            RC_ASSERT(bodies[bodies.slotOf(id)].object == id);
            RC_ASSERT(bodies.moves(bodies.slotOf(id)));
        }
    }));
}

// A rod of two unequal discs: the engine has the centre of mass, the columns the object's frame.
TEST(BodyTable, MotionIsThatOfTheCentreOfMass) {
    HandColumns columns;
    ObjectId const id = columns.body(0, {5, 7}, std::acos(-1.0) / 2);
    // Areas 1 : 4, so the centre lies at (0 * 1 + 10 * 4) / 5 = 8 along the rod.
    columns.shape.set(id, Shape{{circlePiece(1), circlePiece(2, {10, 0})}});
    BodyTable bodies;
    RecordingEngine engine;
    ASSERT_TRUE(add(bodies, columns, engine).empty());
    Body const& body = bodies[0];
    EXPECT_TRUE(body.offCentre);
    EXPECT_NEAR(body.centre.x, 8, 1e-12);
    EXPECT_NEAR(engine.at[0].centre.x, 5, 1e-12) << "turned by a quarter: the rod stands upright";
    EXPECT_NEAR(engine.at[0].centre.y, 15, 1e-12);
    // m (1 r1²/2 + 1 8² + 4 r2²/2 + 4 2²) / 5 by Steiner's theorem.
    EXPECT_NEAR(body.inertia, 3 * (0.5 + 64 + 4 * 2 + 4 * 4) / 5, 1e-9);
    EXPECT_NEAR(length(worldCentre(body, {5, 7}, std::acos(-1.0) / 2) - Vec2{5, 15}), 0, 1e-12);
    EXPECT_TRUE(engine.placed.empty());
    bodies.followMotion(columns.view(), engine);
    EXPECT_TRUE(engine.placed.empty()) << "it is at its place already";
    columns.position.set(id, Position{{5, 8}});
    bodies.followMotion(columns.view(), engine);
    EXPECT_EQ(engine.placed, std::vector<SlotIndex>{0});
    EXPECT_NEAR(engine.at[0].centre.y, 16, 1e-12);
    columns.velocity.set(id, Velocity{{std::nan(""), 0}});
    bodies.followMotion(columns.view(), engine);
    EXPECT_EQ(engine.placed.size(), 1U) << "an invalid place is refused";
}

TEST(BodyTable, InvalidBodiesAreRefusedByName) {
    struct Case {
        std::function<void(HandColumns&, ObjectId)> change;
        char const* says; ///< nullptr: it is accepted
    };
    double const nan = std::nan("");
    auto const massOf = [](double kilograms) {
        return [=](HandColumns& c, ObjectId id) { c.mass.set(id, Mass{kilograms}); };
    };
    auto const frictionOf = [](double coefficient) {
        return [=](HandColumns& c, ObjectId id) { c.friction.set(id, Friction{coefficient}); };
    };
    auto const placeAt = [](Vec2 where) {
        return [=](HandColumns& c, ObjectId id) { c.position.set(id, Position{where}); };
    };
    std::vector<Case> const cases{
        {massOf(1e-6), nullptr},
        {massOf(1e9), nullptr},
        {massOf(0.9e-6), "its mass is"},
        {massOf(1.1e9), "its mass is"},
        {massOf(nan), "its mass is nan kg"},
        {frictionOf(100), nullptr},
        {frictionOf(101), "its friction is 101"},
        {frictionOf(-0.1), "its friction is -0.1"},
        {[](HandColumns& c, ObjectId id) { c.restitution.set(id, Restitution{1.01}); }, "restitution 1.01"},
        {[](HandColumns& c, ObjectId id) {
             c.damping.set(id, Damping{0, 1001});
         },
         "its damping is 0 and 1001"},
        {placeAt({1e6, -1e6}), nullptr},
        {placeAt({1.1e6, 0}), "it is at [1100000, 0] m"},
        {placeAt({nan, 0}), "it is at [nan, 0] m"},
        {[](HandColumns& c, ObjectId id) {
             c.velocity.set(id, Velocity{{0, 1e4}});
         },
         nullptr},
        {[](HandColumns& c, ObjectId id) {
             c.velocity.set(id, Velocity{{0, 2e4}});
         },
         "it moves at [0, 20000]"},
        {[](HandColumns& c, ObjectId id) { c.spin.set(id, AngularVelocity{-2e4}); }, "-20000 rad/s"},
        {[](HandColumns& c, ObjectId id) { c.position.remove(id); }, "a shape but no place"},
        {[](HandColumns& c, ObjectId id) { c.velocity.remove(id); }, "it can move but has no rotation"},
        {[](HandColumns& c, ObjectId id) { c.shape.set(id, Shape{{circlePiece(0)}}); }, "radius is 0"},
        // Nothing moves a fixed body, so its mass is not passed to the engine.
        {[](HandColumns& c, ObjectId id) {
             c.fixed.set(id, {});
             c.mass.set(id, Mass{-1});
             c.velocity.remove(id);
             c.rotation.remove(id);
         },
         nullptr},
    };
    for (std::size_t i = 0; i < cases.size(); ++i) {
        HandColumns columns;
        ObjectId const sound = columns.body(0);
        ObjectId const changed = columns.body(1);
        cases[i].change(columns, changed);
        BodyTable bodies;
        RecordingEngine engine;
        auto const refusals = add(bodies, columns, engine);
        EXPECT_NE(bodies.slotOf(sound), noSlot) << "the other bodies are kept";
        EXPECT_EQ(bodies.slotOf(changed) == noSlot, cases[i].says != nullptr) << i;
        ASSERT_EQ(refusals.size(), cases[i].says != nullptr ? 1U : 0U) << i;
        if (!refusals.empty()) {
            EXPECT_EQ(refusals[0].object, changed);
            EXPECT_NE(refusals[0].why.find(cases[i].says), std::string::npos) << refusals[0].why;
        }
    }
}

TEST(BodyTable, LiquidsAreNotBodies) {
    HandColumns columns;
    ObjectId const id = columns.body(0);
    columns.liquid.set(id, {});
    BodyTable bodies;
    RecordingEngine engine;
    EXPECT_TRUE(add(bodies, columns, engine).empty());
    EXPECT_TRUE(engine.added.empty());
    columns.liquid.remove(id);
    EXPECT_TRUE(add(bodies, columns, engine).empty());
    EXPECT_EQ(engine.added.size(), 1U);
    columns.liquid.set(id, {});
    EXPECT_EQ(bodies.outdated(columns.view()), std::vector<SlotIndex>{0});
}

TEST(BodyTable, ChangesOfAnyPropertyExceptThePlaceMakeABodyOutOfDate) {
    struct Case {
        std::function<void(HandColumns&, ObjectId)> change;
        bool outdates;
    };
    std::vector<Case> const cases{
        {[](HandColumns&, ObjectId) {}, false},
        {[](HandColumns& c, ObjectId id) {
             c.position.set(id, Position{{9, 9}});
         },
         false},
        {[](HandColumns& c, ObjectId id) {
             c.velocity.set(id, Velocity{{9, 9}});
         },
         false},
        {[](HandColumns& c, ObjectId id) { c.shape.set(id, Shape{{boxPiece(1, 2)}}); }, false}, // the same
        {[](HandColumns& c, ObjectId id) { c.shape.set(id, Shape{{boxPiece(1, 3)}}); }, true},
        {[](HandColumns& c, ObjectId id) { c.shape.remove(id); }, true},
        {[](HandColumns& c, ObjectId id) { c.mass.set(id, Mass{4}); }, true},
        {[](HandColumns& c, ObjectId id) { c.fixed.set(id, {}); }, true},
        {[](HandColumns& c, ObjectId id) { c.bullet.set(id, {}); }, true},
        {[](HandColumns& c, ObjectId id) { c.friction.set(id, Friction{0.9}); }, true},
        {[](HandColumns& c, ObjectId id) { c.restitution.set(id, Restitution{0.9}); }, true},
        {[](HandColumns& c, ObjectId id) {
             c.groups.set(id, CollisionGroups{2, 3, 1});
         },
         true},
        {[](HandColumns& c, ObjectId id) {
             c.damping.set(id, Damping{0.5, 0});
         },
         true},
        {[](HandColumns& c, ObjectId id) { c.position.remove(id); }, true},
        {[](HandColumns& c, ObjectId id) { c.spin.remove(id); }, true},
    };
    for (std::size_t i = 0; i < cases.size(); ++i) {
        HandColumns columns;
        static_cast<void>(columns.body(0));
        ObjectId const changed = columns.body(1);
        static_cast<void>(columns.body(2));
        BodyTable bodies;
        RecordingEngine engine;
        ASSERT_TRUE(add(bodies, columns, engine).empty());
        cases[i].change(columns, changed);
        EXPECT_EQ(bodies.outdated(columns.view()),
                  cases[i].outdates ? std::vector<SlotIndex>{1} : std::vector<SlotIndex>{})
            << i;
    }
}

TEST(BodyTable, SlotsAreUsedAgainAndHaltedBodiesAreFixed) {
    HandColumns columns;
    ObjectId const first = columns.body(0);
    ObjectId const second = columns.body(1);
    BodyTable bodies;
    RecordingEngine engine;
    ASSERT_TRUE(add(bodies, columns, engine).empty());
    bodies.remove(bodies.slotOf(first), engine);
    EXPECT_EQ(engine.removed, std::vector<SlotIndex>{0});
    EXPECT_EQ(bodies.slotOf(first), noSlot);
    EXPECT_FALSE(bodies.moves(0));
    EXPECT_FALSE(bodies.moves(noSlot));
    columns.shape.remove(first);
    ObjectId const third = columns.body(2);
    bodies.standStill({third});
    ASSERT_TRUE(add(bodies, columns, engine).empty());
    EXPECT_EQ(bodies.slotOf(third), 0U);
    EXPECT_FALSE(bodies.moves(0));
    EXPECT_TRUE(engine.specs[0].fixed);
    EXPECT_TRUE(bodies.moves(bodies.slotOf(second)));
    EXPECT_TRUE(bodies.outdated(columns.view()).empty()) << "it stands still from then on";
}

TEST(BodyTable, RowsAreFoundAgainWhenColumnsHaveChanged) {
    HandColumns columns;
    ObjectId const late = columns.body(7, {7, 0});
    BodyTable bodies;
    RecordingEngine engine;
    ASSERT_TRUE(add(bodies, columns, engine).empty());
    bodies.findRows(columns.view());
    for (std::uint32_t const index : {0U, 3U, 9U}) {
        columns.position.set({index, 0}, Position{});
        columns.spin.set({index, 0}, AngularVelocity{});
    }
    columns.spin.remove({3, 0});
    bodies.findRows(columns.view());
    MotionRows const rows = bodies[bodies.slotOf(late)].rows;
    EXPECT_EQ(columns.position.values()[rows.position].value, (Vec2{7, 0}));
    EXPECT_EQ(columns.position.owners()[rows.position], late);
    EXPECT_EQ(columns.spin.owners()[rows.spin], late);
    EXPECT_EQ(columns.velocity.owners()[rows.velocity], late);
    EXPECT_EQ(columns.rotation.owners()[rows.rotation], late);
}

} // namespace
} // namespace bodies_test
} // namespace trembler::test
