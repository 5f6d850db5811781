// Stacks stand where geometry says, whatever their size and whatever rests on them.
#include "tests/physics/dynamics/engines/native/small_world.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

namespace trembler::test {
namespace island_solver_test {
namespace {

double unit() {
    return *rc::gen::inRange(0, 1000001) / 1e6;
}

TEST(IslandSolver, StacksOfAnySizeStand) {
    EXPECT_TRUE(rc::check([] {
        double const size = 0.02 * std::pow(50, unit());
        int const boxes = *rc::gen::inRange(1, 11);
        SmallWorld world;
        world.floor();
        SlotIndex top = 0;
        for (int i = 0; i < boxes; ++i) {
            top = world.add(boxShape(size, size), {.at = {0, size * (i + 0.5)}});
        }
        world.step(300);
        RC_ASSERT(std::abs(world.motions[top].centre.y - size * (boxes - 0.5)) < 1e-3);
        RC_ASSERT(std::abs(world.motions[top].centre.x) < 1e-3);
    }));
}

TEST(IslandSolver, StacksBearAThousandTimesTheirWeight) {
    for (double const ratio : {10.0, 100.0, 1000.0}) {
        SmallWorld world;
        world.floor();
        for (int i = 0; i < 5; ++i) {
            world.add(boxShape(0.2, 0.2), {.at = {0, 0.2 * (i + 0.5)}, .mass = 4});
        }
        SlotIndex const weight = world.add(boxShape(0.4, 0.4), {.at = {0, 1.2}, .mass = 4 * ratio});
        for (int i = 0; i < 600; ++i) {
            world.step();
            ASSERT_NEAR(world.motions[weight].centre.y, 1.2, 2e-3) << ratio << ", frame " << i;
        }
    }
}

// Also one that may not fall asleep: what springs of contacts sway by must not grow.
TEST(IslandSolver, TallStacksDoNotSway) {
    for (int const boxes : {12, 30}) {
        SmallWorld world;
        world.settings.sleeping = false;
        world.floor();
        std::vector<SlotIndex> stack;
        for (int i = 0; i < boxes; ++i) {
            stack.push_back(world.add(boxShape(1, 1), {.at = {i % 3 == 1 ? 2e-3 : 0, i + 0.5}}));
        }
        world.step(1200);
        for (int i = 0; i < boxes; ++i) {
            Vec2 const at = world.motions[stack[static_cast<std::size_t>(i)]].centre;
            EXPECT_NEAR(at.x, i % 3 == 1 ? 2e-3 : 0, 1e-4) << i << " of " << boxes;
            EXPECT_NEAR(at.y, i + 0.5, 1e-4) << i << " of " << boxes;
        }
    }
}

// A wall of bricks, whose forces are not determined.
TEST(IslandSolver, AWallOfBricksStands) {
    SmallWorld world;
    world.settings.sleeping = false;
    world.floor();
    std::vector<SlotIndex> top;
    for (int row = 0; row < 10; ++row) {
        top.clear();
        for (int i = 0; i < 4; ++i) {
            top.push_back(
                world.add(boxShape(0.2, 0.1), {.at = {0.2 * i + 0.05 * (row % 2), 0.1 * row + 0.05}}));
        }
    }
    world.step(1200);
    for (std::size_t i = 0; i < top.size(); ++i) {
        EXPECT_NEAR(world.motions[top[i]].centre.x, 0.2 * static_cast<double>(i) + 0.05, 2e-3);
        EXPECT_NEAR(world.motions[top[i]].centre.y, 0.95, 1e-3);
    }
}

// Boxes that overlap at the start part without keeping the speed with which they do.
TEST(IslandSolver, BoxesThatOverlapPartAndStay) {
    SmallWorld world;
    world.settings.sleeping = false;
    world.floor();
    std::vector<SlotIndex> row;
    for (int i = 0; i < 5; ++i) {
        row.push_back(world.add(boxShape(0.5, 0.5), {.at = {0.375 * i, 0.25}}));
    }
    world.step(300);
    for (std::size_t i = 1; i < row.size(); ++i) {
        double const gap = world.motions[row[i]].centre.x - world.motions[row[i - 1]].centre.x - 0.5;
        EXPECT_NEAR(gap, 0, 5e-3);
    }
}

// Whichever box was made first.
TEST(IslandSolver, AStackStandsTheSameIfItIsMadeFromTheTop) {
    SmallWorld world;
    world.floor();
    std::vector<SlotIndex> boxes;
    for (int i = 9; i >= 0; --i) {
        boxes.push_back(world.add(boxShape(0.2, 0.2), {.at = {0, 0.2 * (i + 0.5)}}));
    }
    world.step(300);
    EXPECT_NEAR(world.motions[boxes[0]].centre.y, 1.9, 1e-3);
}

TEST(IslandSolver, SlidesAsFarAsFrictionLets) {
    EXPECT_TRUE(rc::check([] {
        double const friction = 0.1 + unit();
        double const speed = 0.5 + 5 * unit();
        SmallWorld world;
        world.add(boxShape(200, 0.2), {.at = {0, -0.1}, .friction = friction, .fixed = true});
        SlotIndex const box =
            world.add(boxShape(0.4, 0.1), {.at = {0, 0.05}, .velocity = {speed, 0}, .friction = friction});
        world.step(60 + static_cast<int>(60 * speed / (friction * standardGravity)));
        double const way = speed * speed / (2 * friction * standardGravity);
        RC_ASSERT(std::abs(world.motions[box].centre.x - way) < 0.01 * way + 1e-3);
    }));
}

// In a pile the forces are not determined by the weights; it must come to rest all the same.
TEST(IslandSolver, APileComesToRest) {
    SmallWorld world;
    world.floor();
    for (int row = 0; row < 10; ++row) {
        for (int i = 0; i <= row; ++i) {
            world.add(boxShape(0.3, 0.3), {.at = {0.32 * i - 0.16 * row, 0.16 + 0.31 * (9 - row)}});
        }
    }
    world.step(600);
    EXPECT_FALSE(world.engine->anyAwake());
    EXPECT_NEAR(world.motions[1].centre.y, 0.15 + 0.3 * 9, 5e-3);
    EXPECT_NEAR(world.motions[1].angle, 0, 5e-3);
}

// It lands within the support of the lower box, so it has no reason to tilt.
TEST(IslandSolver, ABoxThatLandsOnABoxStaysThere) {
    EXPECT_TRUE(rc::check([] {
        double const height = 1 + 2 * unit();
        double const off = 0.2 * (2 * unit() - 1);
        SmallWorld world;
        world.floor();
        world.add(boxShape(0.5, 0.5), {.at = {0, 0.25}});
        SlotIndex const upper = world.add(boxShape(0.5, 0.5), {.at = {off, height}});
        world.step(200);
        RC_ASSERT(std::abs(world.motions[upper].centre.y - 0.75) < 2e-3);
        RC_ASSERT(std::abs(world.motions[upper].angle) < 5e-3);
    }));
}

// Two pieces of one body press on a fixed ball between them, and cannot give way.
TEST(IslandSolver, WhatIsWedgedFromTheStartIsNotThrownOut) {
    EXPECT_TRUE(rc::check([] {
        double const radius = 0.16 + 0.06 * unit();
        SmallWorld world;
        world.floor();
        world.add(discShape(radius), {.at = {-1.1, 1}, .fixed = true});
        Shape fork;
        fork.pieces = {boxPiece(0.08, 0.2, {0, 0}, 1), boxPiece(0.08, 0.14, {0.3, 0})};
        double const angle = 2 * pi * unit();
        SlotIndex const wedged =
            world.add(fork, {.at = Vec2{-1.1, 1} - rotated({0.03, 0}, angle), .angle = angle});
        for (int i = 0; i < 120; ++i) {
            world.step();
            RC_ASSERT(length(world.motions[wedged].velocity) <
                      8); // from there it falls to the floor with 4.4
        }
    }));
}

} // namespace
} // namespace island_solver_test
} // namespace trembler::test
