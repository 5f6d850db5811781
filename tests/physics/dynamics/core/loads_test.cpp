// Sums of forces on bodies: the loads passed to the engine, and the changes that wake a sleeping body.
#include "physics/dynamics/core/loads.hpp"
#include "tests/physics/dynamics/core/recording_engine.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace trembler::test {
namespace loads_test {
namespace {

Body bodyOf(double mass, double inertia, bool fixed = false) {
    Body body;
    body.object = {0, 0};
    body.mass = mass;
    body.inertia = inertia;
    body.fixed = fixed;
    return body;
}

/// The load of a body of 2 kg and 0.5 kg m² that is asleep under its weight and another force.
class Sleeper {
public:
    Sleeper() {
        engine_.isAwake = {0};
        engine_.hasMoved = {{0, {}}};
        apply({0, -20}, {0, 0}, 3);
        loads_.noteSleepers(engine_, true);
        engine_.woken.clear();
    }
    /// Whether it is woken by these sums of two forces and a torque.
    bool wakesUnder(Vec2 weight, Vec2 other, double torque) {
        engine_.woken.clear();
        apply(weight, other, torque);
        return !engine_.woken.empty();
    }

private:
    void apply(Vec2 weight, Vec2 other, double torque) {
        loads_.clear(1);
        loads_.add(0, weight, torque);
        loads_.add(0, other, 0);
        loads_.apply(bodies_, engine_);
    }
    std::vector<Body> bodies_{bodyOf(2, 0.5)};
    RecordingEngine engine_;
    LoadTable loads_;
};

TEST(LoadTable, AddsUpForcesAndTorquesForEachBody) {
    LoadTable loads;
    RecordingEngine engine;
    std::vector<Body> bodies{bodyOf(2, 0.5), bodyOf(1, 1, true), bodyOf(3, 2), Body{}};
    loads.clear(4);
    loads.add(0, {1, 2}, 3);
    loads.add(0, {-4, 1}, 0.5);
    loads.add(1, {100, 100}, 100);
    loads.add(3, {1, 1}, 1);
    loads.apply(bodies, engine);
    ASSERT_EQ(engine.loads.size(), 4U);
    EXPECT_EQ(engine.loads[0].force, (Vec2{-3, 3}));
    EXPECT_EQ(engine.loads[0].torque, 3.5);
    EXPECT_EQ(engine.loads[1].force, (Vec2{})) << "fixed";
    EXPECT_EQ(engine.loads[2].force, (Vec2{})) << "no forces";
    EXPECT_EQ(engine.loads[3].force, (Vec2{})) << "a free slot";
    EXPECT_EQ(loads.sums()[0].gross, 8) << "the sum of the forces' magnitudes";
    EXPECT_TRUE(engine.drags.empty());
    loads.clear(4);
    loads.addDrag(2, {}, 5, 0, 6, 7);
    loads.apply(bodies, engine);
    EXPECT_EQ(engine.loads[0].force, (Vec2{})) << "a new sum";
    ASSERT_EQ(engine.drags.size(), 4U);
    EXPECT_EQ(engine.drags[2].xx, 5);
    EXPECT_EQ(engine.drags[2].yy, 6);
    EXPECT_EQ(engine.drags[2].tt, 7);
    EXPECT_FALSE(engine.drags[0].any());
    loads.clear(4);
    loads.apply(bodies, engine);
    EXPECT_TRUE(engine.drags.empty()) << "earlier sums are not kept";
}

TEST(LoadTable, ExcessiveForcesAreLimitedWithoutChangingTheirDirection) {
    std::vector<Body> const bodies{bodyOf(2, 0.5)};
    auto const bounded = [&](Vec2 force, double torque) {
        LoadTable loads;
        RecordingEngine engine;
        loads.clear(1);
        loads.add(0, force, torque);
        loads.apply(bodies, engine);
        return engine.loads[0];
    };
    Load const most = bounded({3e9, 4e9}, 1e9);
    EXPECT_NEAR(length(most.force), 2 * maximumAcceleration, 1e-3);
    EXPECT_NEAR(most.force.y / most.force.x, 4.0 / 3, 1e-12);
    EXPECT_EQ(most.torque, 0.5 * maximumAngularAcceleration);
    EXPECT_EQ(bounded({}, -1e9).torque, -0.5 * maximumAngularAcceleration);
    constexpr double inf = std::numeric_limits<double>::infinity();
    for (double const wild : {inf, -inf, std::nan(""), 1e308, -1e308}) {
        Load const load = bounded({wild, wild}, wild);
        EXPECT_TRUE(isFinite(load.force) && std::isfinite(load.torque)) << wild;
        EXPECT_LE(length(load.force), 2.001 * maximumAcceleration) << wild;
    }
    Load const plain = bounded({1.9e6, 0}, 4e5);
    EXPECT_EQ(plain.force, (Vec2{1.9e6, 0}));
    EXPECT_EQ(plain.torque, 4e5);
}

// A five-hundredth of all forces, here 40 of 20000 mN, or a force whose effect would take a quarter of an
// hour.
TEST(LoadTable, ASleepingBodyWakesWhenItsLoadChangesByAFiveHundredth) {
    Sleeper sleeper;
    EXPECT_FALSE(sleeper.wakesUnder({0, -20}, {}, 3)) << "the same";
    EXPECT_FALSE(sleeper.wakesUnder({0, -20}, {0.039, 0}, 3));
    EXPECT_TRUE(sleeper.wakesUnder({0, -20}, {0.045, 0}, 3));
    EXPECT_FALSE(sleeper.wakesUnder({0, -20.039}, {}, 3));
    EXPECT_TRUE(sleeper.wakesUnder({0, -20.045}, {}, 3));
    EXPECT_TRUE(sleeper.wakesUnder({}, {}, 0)) << "all forces removed";
    // If forces cancel, a five-hundredth of their magnitudes is more.
    EXPECT_FALSE(sleeper.wakesUnder({0, -120}, {0, 100.1}, 3));
    EXPECT_TRUE(sleeper.wakesUnder({0, -120}, {0, 101}, 3));
    // Torques: a five-hundredth of the torque, and of the forces at the radius of gyration, 0.5 m.
    EXPECT_FALSE(sleeper.wakesUnder({0, -20}, {}, 3.02));
    EXPECT_TRUE(sleeper.wakesUnder({0, -20}, {}, 3.03));
    EXPECT_TRUE(sleeper.wakesUnder({0, -20}, {}, -3));
}

TEST(LoadTable, AwakeBodiesAreNotWokenAndSleepingOnesKeepTheLoadOfFallingAsleep) {
    std::vector<Body> const bodies{bodyOf(2, 0.5)};
    LoadTable loads;
    RecordingEngine engine;
    engine.isAwake = {1};
    engine.hasMoved = {{0, {}}};
    auto const apply = [&](double force) {
        engine.woken.clear();
        loads.clear(1);
        loads.add(0, {force, 0}, 0);
        loads.apply(bodies, engine);
        loads.noteSleepers(engine, true);
        return !engine.woken.empty();
    };
    EXPECT_FALSE(apply(5));
    EXPECT_FALSE(apply(50)) << "it is awake";
    engine.isAwake = {0};
    EXPECT_FALSE(apply(7)) << "it falls asleep in this step, under 7 N";
    engine.hasMoved.clear();
    EXPECT_FALSE(apply(7));
    EXPECT_TRUE(apply(8));
    EXPECT_FALSE(apply(7)) << "loads tested in between have no influence";
}

TEST(LoadTable, ChangedMuchComparesWithTheSumsWhenItWasLastTrue) {
    LoadTable loads;
    auto const with = [&](std::vector<double> const& forces) {
        loads.clear(forces.size());
        for (std::size_t slot = 0; slot < forces.size(); ++slot) {
            loads.add(static_cast<SlotIndex>(slot), {forces[slot], 0}, 0);
        }
        return loads.changedMuch();
    };
    EXPECT_TRUE(with({8})) << "a first load";
    EXPECT_FALSE(with({8}));
    EXPECT_FALSE(with({8.5}));
    EXPECT_FALSE(with({9})) << "an eighth of 9 is more than 1";
    EXPECT_TRUE(with({9.2})) << "small changes add up";
    EXPECT_TRUE(with({9.2, 1})) << "a new body with a load";
    EXPECT_FALSE(with({9.2, 1, 0})) << "one without";
    EXPECT_TRUE(with({9.2})) << "bodies were removed";
    EXPECT_TRUE(with({-9.2}));
}

} // namespace
} // namespace loads_test
} // namespace trembler::test
