// The limit for a group of sources, compared with the paths from points in it.
#include "audio/effect/hearing/group_path.hpp"
#include "audio/effect/hearing/sound_path.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

namespace trembler {
namespace {

Obstacle obstacleAt(Vec2 at, double width, double height, double angle = 0, double density = 2000) {
    std::vector<Obstacle> made;
    addObstacles(made, ObjectId{7, 0}, Shape{{boxPiece(width, height)}}, at, angle, density);
    return made.front();
}

double someNumber(int from, int to) {
    return *rc::gen::inRange(from * 100, to * 100) / 100.0 + 0.0017;
}

TEST(GroupPath, TheLimitForAGroupHoldsForEachPointOfIt) {
    EXPECT_TRUE(rc::check("among boxes in a corridor", [] {
        std::vector<Obstacle> boxes;
        for (int i = *rc::gen::inRange(0, 30); i > 0; --i) {
            boxes.push_back(obstacleAt({someNumber(0, 20), 0.3 * someNumber(-1, 1)},
                                       0.02 + 0.5 * someNumber(0, 1), 0.02 + 2 * someNumber(0, 2),
                                       someNumber(-3, 3), 0.1 + someNumber(0, 3000)));
            boxes.back().object = {static_cast<std::uint32_t>(i), 0};
        }
        ObstacleField const field(boxes);
        Bounds const group = boundsOf(
            {{someNumber(0, 24), 0.5 * someNumber(-1, 1)}, {someNumber(0, 24), 0.5 * someNumber(-1, 1)}});
        Vec2 const to{someNumber(-4, 24), someNumber(-1, 1)};
        ObjectId const ear{3, 0};
        double const frequency = 50 + someNumber(0, 4000);
        double const most = shareAtMost(field, ear, group, to, frequency, 0);
        RC_ASSERT(most <= 1);
        double const enough = 0.01 * *rc::gen::inRange(0, 100);
        double const early = shareAtMost(field, ear, group, to, frequency, enough);
        RC_ASSERT(early == most || (early < enough && most <= early));
        Vec2 const extent = group.upper - group.lower;
        for (int i = 0; i < 20; ++i) {
            Vec2 const from = group.lower + Vec2{extent.x * 0.01 * *rc::gen::inRange(0, 101),
                                                 extent.y * 0.01 * *rc::gen::inRange(0, 101)};
            double const r = std::max(0.1, length(to - from));
            double const share = transmission(field, std::span(&ear, 1), from, to,
                                              frequency + someNumber(0, 900), PathDetail::straight);
            RC_ASSERT(share * r * r <= most * (1 + 1e-9));
        }
    }));
    std::vector<Obstacle> const wall{obstacleAt({2, 0}, 1, 4)};
    Bounds const behind{{5, -0.5}, {9, 0.5}};
    EXPECT_NEAR(shareAtMost(ObstacleField(wall), {}, behind, {0, 0}, 1000, 0), 1 / 3.0, 1e-3);
    EXPECT_EQ(shareAtMost(ObstacleField(wall), wall.front().object, behind, {0, 0}, 1000, 0), 1);
    EXPECT_EQ(shareAtMost(ObstacleField(wall), {}, {{-5, -0.5}, {-1, 0.5}}, {0, 0}, 1000, 0), 1);
}

} // namespace
} // namespace trembler
