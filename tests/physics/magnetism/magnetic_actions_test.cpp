// Which magnet acts on which object: events that begin and end, and nothing without a trace.
#include "physics/inverse_square/kernels.hpp"
#include "physics/magnetism/magnetic_actions.hpp"
#include "tests/physics/magnetism/magnet_world.hpp"
#include "tests/physics/magnetism/magnetic_things.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

namespace trembler {
namespace magnetic_actions_test {
namespace {

constexpr MagneticPoles north{PoleSet::north, {}, {}};
constexpr MagneticPoles south{PoleSet::south, {}, {}};

using Told = std::tuple<std::string, std::uint32_t, std::uint32_t>; ///< what, object, by

/// Those that can move have a velocity.
struct Things : test::MagneticThings {
    ObjectId thing(Vec2 at, double strength, double susceptibility, MagneticPoles const& poles,
                   bool moves = true) {
        ObjectId const id = MagneticThings::thing(at, strength, susceptibility, poles);
        if (moves) {
            velocities.set(id, {});
        }
        return id;
    }
    ObjectId pole(Vec2 at, double strength, MagneticPoles const& poles, bool moves = true) {
        return thing(at, strength, 0, poles, moves);
    }
    ObjectId iron(Vec2 at, bool moves = true) { return thing(at, 0, 50, {}, moves); }

    /// The events of an update, sorted; their causes are kept by the event's number.
    std::vector<Told> follow() {
        MagneticPoints points;
        points.gather(columns(), 0);
        points.exportForces(into);
        std::vector<Told> told;
        actions.follow(
            points, columns(), switching,
            [&](std::string_view what, std::span<ObjectId const> objects, std::span<EventId const> causes) {
                told.emplace_back(what, objects[0].index, objects[1].index);
                causesOf.emplace_back(causes.begin(), causes.end());
                return EventId{1000 + causesOf.size()};
            },
            into);
        actions.nameCauses(into);
        std::sort(told.begin(), told.end());
        return told;
    }

    MagneticActions actions;
    std::vector<EventId> switching;
    std::vector<std::vector<EventId>> causesOf;
    MagneticForce into;
};

TEST(MagneticActions, EachMagnetIsNamedWithWhatItDoes) {
    Things things;
    things.iron({0, 0});
    things.pole({1, 0}, 1000, north, false);
    things.pole({-1, 0}, 1000, south, false);
    things.pole({0, 1}, 1000, north);
    EXPECT_EQ(things.follow(), (std::vector<Told>{{"attracted", 0, 1},
                                                  {"attracted", 0, 2},
                                                  {"attracted", 0, 3},
                                                  {"attracted", 3, 0},
                                                  {"attracted", 3, 2},
                                                  {"repelled", 3, 1}}))
        << "nothing follows from forces on what is fixed";
    EXPECT_TRUE(things.follow().empty()) << "they go on";
    ASSERT_EQ(things.into.actions.size(), 6U);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(things.into.actions[i].force, length(poleForce({1, 0}, 1000, 50)), 1e-12);
    }
    things.positions.set(ObjectId{2, 0}, {{-1000, 0}});
    EXPECT_EQ(things.follow(),
              (std::vector<Told>{{"no longer attracted", 0, 2}, {"no longer attracted", 3, 2}}));
    things.poleSets.set(ObjectId{1, 0}, south);
    EXPECT_EQ(things.follow(), (std::vector<Told>{{"attracted", 3, 1}})) << "instead of being repelled";
}

TEST(MagneticActions, TheSwitchingIsTheCause) {
    Things things;
    ObjectId const iron = things.iron({0, 0});
    ObjectId const coil = things.pole({1, 0}, 1000, north, false);
    things.pole({-0.5, 0}, 1000, north, false);
    things.magnets.set(coil, Magnet{false, 0});
    things.switching = {EventId{}, EventId{7}};
    ASSERT_EQ(things.follow(), (std::vector<Told>{{"attracted", 0, 2}}));
    EXPECT_EQ(things.causesOf.back(), (std::vector{EventId{}, EventId{}})) << "a permanent magnet";
    EventId const permanent = things.into.actions.front().event;
    things.magnets.set(coil, Magnet{true, 1});
    things.switching[1] = EventId{8};
    ASSERT_EQ(things.follow(), (std::vector<Told>{{"attracted", 0, 1}}));
    EXPECT_EQ(things.causesOf.back(), (std::vector{EventId{}, EventId{8}}));
    auto const force = std::find_if(things.into.forces.begin(), things.into.forces.end(),
                                    [&](MagneticForce::Entry const& one) { return one.object == iron; });
    ASSERT_NE(force, things.into.forces.end());
    EXPECT_EQ(force->cause, permanent) << "the stronger of two";
    things.magnets.set(coil, Magnet{false, 0.5});
    things.switching[1] = EventId{9};
    EXPECT_TRUE(things.follow().empty()) << "it cools down";
    things.magnets.set(coil, Magnet{false, 0});
    ASSERT_EQ(things.follow(), (std::vector<Told>{{"no longer attracted", 0, 1}}));
    EXPECT_EQ(things.causesOf.back(), (std::vector{EventId{}, EventId{9}}));
}

// Reaction: what a magnet attracts, and cannot move, attracts the magnet.
TEST(MagneticActions, AMagnetIsDrawnToFixedIron) {
    Things things;
    things.iron({0, 0}, false);
    ObjectId const coil = things.pole({0.5, 0}, 1000, north);
    things.switching = {EventId{}, EventId{5}};
    ASSERT_EQ(things.follow(), (std::vector<Told>{{"attracted", 1, 0}}));
    EXPECT_EQ(things.causesOf.back(), (std::vector{EventId{5}, EventId{}})) << "its own switching";
    EXPECT_EQ(things.into.actions.front().object, coil);
}

// The two ends of a bar act in opposite directions; the nearer one decides.
TEST(MagneticActions, OfABarTheNearerPoleDecides) {
    Things things;
    things.pole({0, 0}, 1000, north);
    ObjectId const bar = things.pole({1, 0}, 1000, {PoleSet::both, {-0.3, 0}, {0.3, 0}}, false);
    EXPECT_EQ(things.follow(), (std::vector<Told>{{"repelled", 0, 1}}));
    things.rotations.set(bar, {std::acos(-1.0)});
    EXPECT_EQ(things.follow(), (std::vector<Told>{{"attracted", 0, 1}}));
}

TEST(MagneticActions, OfManyTheStrongestAreFollowed) {
    Things things;
    things.iron({0, 0});
    for (std::size_t i = 0; i < mostActions + 4; ++i) { // the first ones are the weakest
        things.pole({1, 0}, 1000 + 10.0 * static_cast<double>(i), north, false);
    }
    std::vector<Told> const told = things.follow();
    ASSERT_EQ(told.size(), mostActions);
    for (auto const& [what, object, by] : told) {
        EXPECT_GT(by, 4U);
    }
    things.strengths.set(ObjectId{1, 0}, {1500, 0});
    EXPECT_TRUE(things.follow().empty()) << "none changes places for a little more";
    things.strengths.set(ObjectId{1, 0}, {4000, 0});
    EXPECT_EQ(things.follow(), (std::vector<Told>{{"attracted", 0, 1}, {"no longer attracted", 0, 5}}));
}

TEST(MagneticActions, AreOutdatedOnceSomethingHasMoved) {
    Things things;
    things.iron({0, 0});
    ObjectId const magnet = things.pole({1, 0}, 1000, north);
    auto const outdated = [&] {
        MagneticPoints points;
        points.gather(things.columns(), 0);
        return things.actions.outdated(points);
    };
    EXPECT_TRUE(outdated()) << "before the first time";
    things.follow();
    EXPECT_FALSE(outdated());
    for (int i = 1; i <= 3; ++i) { // by little, but of the same sign each time
        things.positions.set(magnet, {{1 + 0.3 * i * followDistance, 0}});
        EXPECT_FALSE(outdated());
    }
    things.positions.set(magnet, {{1 + 1.2 * followDistance, 0}});
    EXPECT_TRUE(outdated());
    things.follow();
    EXPECT_FALSE(outdated());
    things.strengths.set(magnet, {1001, 0});
    EXPECT_TRUE(outdated());
    things.follow();
    things.iron({0, 5});
    EXPECT_TRUE(outdated());
}

TEST(MagneticActions, WithoutATraceNothingIsFollowed) {
    test::MagnetWorld magnets;
    ObjectId const iron = magnets.soft({0, 1}, 10);
    magnets.world.store().column<Velocity>().set(iron, {});
    ObjectId const coil = magnets.electromagnet({0, 0}, 4);
    magnets.world.store().column<test::Switch>().set(coil, {true});
    magnets.run(5);
    EXPECT_LT(magnets.force(iron).y, 0);
    EXPECT_TRUE(magnets.world.find<MagneticForce>()->actions.empty());
}

} // namespace
} // namespace magnetic_actions_test
} // namespace trembler
