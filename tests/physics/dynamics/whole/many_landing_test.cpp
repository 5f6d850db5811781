// Many bodies that land at once: none falls through the floor. Their cost is measured in bench/growth.cpp.
#include "tests/physics/dynamics/scene.hpp"

#include <gtest/gtest.h>

namespace trembler::test {
namespace {

class ManyLanding : public OnEveryEngine {};
TREMBLER_ON_EVERY_ENGINE(ManyLanding);

TEST_P(ManyLanding, AreAllStoppedByAThinFloorAtAnySpeed) {
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

// In frames of many substeps, Box2D's own search for impacts is too expensive as well.
TEST_P(ManyLanding, AreAllStoppedInManySubstepsAtAnySpeed) {
    constexpr int count = 80;
    Scene scene({.solver = {.substeps = 64}});
    scene.fixed("floor", boxPiece(0.3 * count + 10, 0.02), {0.15 * count, 0});
    std::vector<ObjectId> all;
    for (int i = 0; i < count; ++i) {
        all.push_back(scene.ball({0.3 * i, 0.5 + 0.01 * (i % 10)}, 0.05));
        scene.give(all.back(), Velocity{{0, -1000}}); // 0.26 m in a substep
    }
    scene.run(10);
    for (ObjectId const id : all) {
        ASSERT_GT(scene.at(id).y, 0.02);
    }
}

} // namespace
} // namespace trembler::test
