// Thousands of things that land, or rest, at once: each costs as much as one alone, and none falls through.
#include "physics/dynamics/properties/solver_choice.hpp"
#include "tests/physics/dynamics/scene.hpp"

#include <gtest/gtest.h>

#include <ctime>

namespace trembler::test {
namespace {

class ManyLanding : public OnEveryEngine {};
TREMBLER_ON_EVERY_ENGINE(ManyLanding);

// Processor time of this process, in s: other programs do not count.
double processorTime() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Row {
    Scene scene;
    std::vector<ObjectId> all;

    Row(int count, double height, double speed) {
        scene.fixed("floor", boxPiece(0.3 * count + 10, 1), {0.15 * count, -0.5});
        for (int i = 0; i < count; ++i) {
            all.push_back(
                scene.body("box " + std::to_string(i), boxPiece(0.2, 0.2), {0.3 * i, 0.1 + height}));
            scene.give(all.back(), Velocity{{0, -speed}});
        }
    }
    /// The time of `frames` frames in s.
    double time(int frames) {
        double const before = processorTime();
        scene.run(frames);
        return processorTime() - before;
    }
};

TEST_P(ManyLanding, TakeTimeInProportionToTheirNumber) {
    if (!on("box2d")) {
        GTEST_SKIP() << "the others test each path by itself anyway";
    }
    // Eight times as many took sixty-four times as long.
    double const few = Row(2000, 0.05, 6).time(12);
    double const many = Row(16000, 0.05, 6).time(12);
    EXPECT_LT(many, 24 * few + 0.2);
}

TEST_P(ManyLanding, AtRestTakeTimeInProportionToTheirNumber) {
    if (!on("box2d")) {
        GTEST_SKIP() << "the others test each path by itself anyway";
    }
    double const few = Row(2000, 0, 0).time(4);
    double const many = Row(16000, 0, 0).time(4);
    EXPECT_LT(many, 24 * few + 0.2);
}

TEST_P(ManyLanding, AreAllHeldByAThinFloorHoweverFast) {
    constexpr int count = 2500;
    Scene scene;
    scene.fixed("floor", boxPiece(0.3 * count + 10, 0.02), {0.15 * count, 0});
    std::vector<ObjectId> all;
    for (int i = 0; i < count; ++i) {
        all.push_back(
            scene.body("box " + std::to_string(i), boxPiece(0.2, 0.2), {0.3 * i, 0.5 + 0.001 * (i % 100)}));
        scene.give(all.back(), Velocity{{0, -60}});
    }
    scene.run(30);
    for (ObjectId const id : all) {
        ASSERT_GT(scene.at(id).y, 0.05);
    }
}

} // namespace
} // namespace trembler::test
