#include "tests/physics/dynamics/scene.hpp"

#include <gtest/gtest.h>

namespace trembler::test {
namespace {

// Semi-implicit Euler (v += h g, then x += h v) is exact in v and falls ahead in x by g h t / 2.
TEST(Motion, ProjectileFollowsTheParabolaOfItsIntegrator) {
    for (int const substeps : {1, 4, 16}) {
        Scene scene(false, {.substeps = substeps});
        ObjectId const ball = scene.body("ball", circlePiece(0.1), {0, 0});
        scene.give(ball, Velocity{{7, 9}});
        double const h = frameDuration / substeps;
        scene.run(1); // the first pull is applied at the end of frame 1: one frame without gravity
        EXPECT_NEAR(scene.at(ball).y, 9 * frameDuration, 1e-5);
        for (int frame = 1; frame <= 120; ++frame) {
            scene.run(1);
            double const t = frame * frameDuration;
            double const y = 9 * (t + frameDuration) - 9.81 * t * t / 2 - 9.81 * h * t / 2;
            ASSERT_NEAR(scene.at(ball).x, 7 * (t + frameDuration), 5e-4);
            ASSERT_NEAR(scene.at(ball).y, y, 5e-4) << substeps << " substeps, t = " << t;
            ASSERT_NEAR(scene.velocity(ball).y, 9 - 9.81 * t, 5e-4);
        }
    }
}

TEST(Motion, ABallComesToRestAndEverythingSleeps) {
    Scene scene;
    ObjectId const floor = scene.fixed("floor", boxPiece(10, 1), {0, -0.5});
    ObjectId const ball = scene.body("ball", boxPiece(0.4, 0.4), {0, 1});
    scene.run(200);
    EXPECT_TRUE(scene.touching(floor, ball));
    EXPECT_NEAR(scene.at(ball).y, 0.2, 0.01);
    EXPECT_EQ(scene.dynamics(), Activity::asleep);
    std::uint64_t const hash = scene.world->stateHash();
    scene.run(100);
    EXPECT_EQ(hash, scene.world->stateHash());
}

} // namespace
} // namespace trembler::test
