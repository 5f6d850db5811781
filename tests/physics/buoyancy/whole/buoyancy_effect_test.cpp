// Buoyancy among other effects: frames, trace, sleep, swaps, threads, collision groups.
#include "runtime/trace/tracer.hpp"
#include "tests/physics/buoyancy/pool.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace trembler::test {
namespace {

TEST(BuoyancyEffect, IsConstructedOnlyWithLiquids) {
    Pool dry;
    dry.body("box", boxPiece(0.2, 0.2), {0, 0}, 500);
    dry.run(3);
    for (char const* component : {"Buoyancy", "Particle Buoyancy", "Liquid Drag", "Buoyancy <- Gravity",
                                  "Dynamics <- Buoyancy", "Dynamics <- Liquid Drag"}) {
        EXPECT_EQ(dry.activity(component), Activity::absent) << component;
    }
    Pool wet;
    wet.water();
    wet.body("box", boxPiece(0.2, 0.2), {0, 0}, 500);
    wet.run(3);
    EXPECT_EQ(wet.activity("Buoyancy"), Activity::active);
    EXPECT_EQ(wet.activity("Particle Buoyancy"), Activity::absent);
}

TEST(BuoyancyEffect, ComputesInTheFirstFrameTheForceOfTheSecond) {
    // The thesis needs three: collisions in 1, F_B in 2, motion in 3 (6.12.3). Here nothing depends on
    // collisions, and gravity and F_B act in the same frame, so a body in balance never moves.
    Pool pool;
    pool.water();
    ObjectId const box = pool.body("box", boxPiece(0.4, 0.2), {0, 0}, 500);
    ObjectId const cork = pool.body("cork", boxPiece(0.4, 0.2), {2, -1}, 100);
    pool.run(1);
    EXPECT_NEAR(pool.force(box).y, pool.mass(box) * 9.81, 1e-9);
    EXPECT_NEAR(length(pool.centre(box) - Vec2{0, -0.05}), 0, 1e-12);
    EXPECT_EQ(pool.velocity(cork).y, 0);
    pool.run(1);
    EXPECT_GT(pool.velocity(cork).y, 0);
    pool.run(100);
    EXPECT_NEAR(pool.at(box).y, 0, 1e-6);
}

TEST(BuoyancyEffect, LiquidsCollideWithNothingAndDoNotMove) {
    Pool pool;
    ObjectId const water = pool.water();
    ObjectId const floor = pool.fixed("floor", boxPiece(10, 1), {0, -5.5});
    ObjectId const stone = pool.body("stone", circlePiece(0.2), {0, 1}, 2500);
    pool.run(1);
    EXPECT_GT(pool.mass(water), 0);
    EXPECT_EQ(pool.world->find<Velocity>(water), nullptr);
    bool onFloor = false;
    for (int frame = 0; frame < 600; ++frame) {
        pool.run(1);
        for (TouchingPair const& pair : pool.world->find<Contacts>()->current) {
            EXPECT_TRUE(pair.a != water && pair.b != water);
            onFloor = onFloor || (pair.a == floor && pair.b == stone);
        }
    }
    EXPECT_TRUE(onFloor);
    EXPECT_NEAR(pool.at(stone).y, -4.8, 0.01);
}

TEST(BuoyancyEffect, ABodyThatBecomesALiquidIsNoBodyAnyMore) {
    Pool pool;
    ObjectId const block = pool.fixed("block", boxPiece(4, 2), {0, -1});
    ObjectId const ball = pool.body("ball", circlePiece(0.2), {0, 0.5}, 3000);
    pool.seconds(2);
    EXPECT_NEAR(pool.at(ball).y, 0.2, 0.01);
    pool.give(block, Liquid{});
    pool.seconds(2);
    EXPECT_LT(pool.at(ball).y, -0.5);
}

TEST(BuoyancyEffect, ComesToRestAndSleeps) {
    Pool pool;
    pool.water();
    ObjectId const box = pool.body("box", boxPiece(0.4, 0.2), {0, 0.3}, 300);
    pool.seconds(60);
    for (char const* component : {"Buoyancy", "Liquid Drag", "Buoyancy <- Gravity", "Dynamics <- Buoyancy",
                                  "Dynamics <- Liquid Drag"}) {
        EXPECT_EQ(pool.activity(component), Activity::asleep) << component;
    }
    Vec2 const at = pool.at(box);
    std::uint64_t const hash = pool.world->stateHash();
    pool.seconds(60);
    EXPECT_EQ(pool.at(box), at);
    EXPECT_EQ(pool.world->stateHash(), hash);
}

TEST(BuoyancyEffect, WakesWhenGravityOrLiquidChange) {
    Pool pool;
    ObjectId const water = pool.water();
    ObjectId const box = pool.body("box", boxPiece(0.4, 0.2), {0, 0}, 500);
    pool.seconds(30);
    ASSERT_EQ(pool.activity("Buoyancy"), Activity::asleep);
    pool.give(water, Density{1500});
    pool.seconds(30);
    EXPECT_NEAR(0.1 - pool.at(box).y, 0.2 / 3, 1e-3);
    pool.give(water, Position{{0, -24}});
    pool.seconds(30);
    EXPECT_NEAR(1.1 - pool.at(box).y, 0.2 / 3, 1e-3);
    pool.give(pool.world->store().find("world"), GravityField{{0, -1.62}});
    pool.seconds(60);
    EXPECT_NEAR(pool.force(box).y, pool.mass(box) * 1.62, 0.02);
    EXPECT_NEAR(1.1 - pool.at(box).y, 0.2 / 3, 1e-3);
}

TEST(BuoyancyEffect, TraceNamesTheImmersionAsTheCauseOfTheForce) {
    Pool::Options options;
    options.trace = true;
    Pool pool(options);
    pool.water();
    pool.body("ball", circlePiece(0.1), {0, 0.4}, 500);
    pool.seconds(5);
    std::span<Event const> const events = pool.world->tracer()->events();
    auto const named = [&](std::string const& what) {
        return std::find_if(events.begin(), events.end(),
                            [&](Event const& event) { return event.event == what; });
    };
    auto const enters = named("enters the liquid");
    ASSERT_NE(enters, events.end());
    EXPECT_EQ(enters->objects, (std::vector<std::string>{"ball", "water"}));
    // Falls 0.3 m: 0.247 s, from the second frame on.
    EXPECT_NEAR(static_cast<double>(enters->frame), 1 + 60 * std::sqrt(2 * 0.3 / 9.81), 2);
    auto const lifts = named("addForceToPoint");
    ASSERT_NE(lifts, events.end());
    EXPECT_EQ(lifts->causes, std::vector<EventId>{enters->id});
    EXPECT_GE(lifts->frame, enters->frame);
}

TEST(BuoyancyEffect, DetailLevelsSwapInARunningWorld) {
    Pool pool;
    pool.water();
    ObjectId const box = pool.body("box", boxPiece(0.6, 0.2), {0, 0.1}, 400);
    pool.seconds(20);
    double const exact = pool.at(box).y;
    double lowest = exact;
    double highest = exact;
    for (char const* level : {"particles", "exact", "particles", "exact"}) {
        pool.world->setDetail("buoyancy", level);
        for (int frame = 0; frame < 300; ++frame) {
            pool.run(1);
            lowest = std::min(lowest, pool.at(box).y);
            highest = std::max(highest, pool.at(box).y);
        }
    }
    EXPECT_EQ(pool.activity("Buoyancy") == Activity::absent, false);
    EXPECT_GT(lowest, exact - 0.02);
    EXPECT_LT(highest, exact + 0.02);
    EXPECT_NEAR(pool.at(box).y, exact, 1e-3);
}

TEST(BuoyancyEffect, TheNumberOfParticlesIsAPropertyOfTheWorld) {
    auto const force = [](int particles) {
        Pool::Options options;
        options.detail = "particles";
        options.buoyancy.particles = particles;
        Pool pool(options);
        pool.water();
        ObjectId const box = pool.body("box", boxPiece(0.6, 0.2), {0, 0.03}, 400, 0.2);
        pool.run(1);
        return pool.force(box).y;
    };
    Pool pool;
    pool.water();
    ObjectId const box = pool.body("box", boxPiece(0.6, 0.2), {0, 0.03}, 400, 0.2);
    pool.run(1);
    double const exact = pool.force(box).y;
    EXPECT_LT(std::abs(force(256) - exact), 0.02 * exact);
    EXPECT_LT(std::abs(force(256) - exact), std::abs(force(4) - exact));
}

TEST(BuoyancyEffect, BitsDoNotDependOnThreads) {
    for (char const* detail : {"exact", "particles"}) {
        std::vector<std::uint64_t> hashes;
        for (int const threads : {1, 2, 3, 8}) {
            Pool::Options options;
            options.detail = detail;
            options.threads = threads;
            Pool pool(options);
            pool.water();
            for (int i = 0; i < 1500; ++i) { // more than one chunk
                pool.body("body " + std::to_string(i), i % 2 == 0 ? boxPiece(0.2, 0.1) : circlePiece(0.08),
                          {-40 + 0.7 * (i % 110), 0.3 * (i / 110) - 4}, 100.0 + i % 1500, 0.1 * i);
            }
            pool.run(30);
            hashes.push_back(pool.world->stateHash());
        }
        for (std::uint64_t const hash : hashes) {
            EXPECT_EQ(hash, hashes.front()) << detail;
        }
    }
}

TEST(BuoyancyEffect, DestroyedObjectsAreRemoved) {
    Pool pool;
    ObjectId const water = pool.water();
    ObjectId const box = pool.body("box", boxPiece(0.4, 0.2), {0, 0}, 500);
    ObjectId const other = pool.body("other", boxPiece(0.4, 0.2), {2, 0}, 500);
    pool.seconds(1);
    pool.world->feed({PlayerInput::Kind::remove, box, {}, {}});
    pool.seconds(1);
    ASSERT_EQ(pool.world->find<BuoyancyForce>()->forces.size(), 1U);
    EXPECT_EQ(pool.world->find<BuoyancyForce>()->forces.front().object, other);
    pool.world->feed({PlayerInput::Kind::remove, water, {}, {}});
    pool.seconds(2);
    EXPECT_LT(pool.at(other).y, -5);
    EXPECT_EQ(pool.activity("Buoyancy"), Activity::absent);
}

} // namespace
} // namespace trembler::test
