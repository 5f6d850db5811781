// The reference for contacts, compared with shapes of known gap and with sampled separations.
#include "tests/physics/dynamics/brute_gap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace trembler::test {
namespace brute_gap_test {
namespace {

constexpr double pi = std::numbers::pi;

double gapOf(ShapePiece const& a, ShapePiece const& b, Vec2 at, double angle = 0, double skin = 0) {
    Shape const first{{a}};
    Shape const second{{b}};
    return bruteGap({first, {}, 0}, {second, at, angle}, skin);
}

TEST(BruteGap, AgreesWithKnownGaps) {
    constexpr double precise = 1e-12;
    EXPECT_NEAR(gapOf(circlePiece(0.3), circlePiece(0.2), {3, 4}), 4.5, precise);
    EXPECT_NEAR(gapOf(circlePiece(0.3), circlePiece(0.2), {0.3, 0.4}), 0, precise);
    EXPECT_NEAR(gapOf(circlePiece(0.3), circlePiece(0.2), {0, 0.4}), -0.1, precise);
    EXPECT_NEAR(gapOf(boxPiece(2, 1), boxPiece(1, 1), {0.4, 1.2}), 0.2, precise);
    EXPECT_NEAR(gapOf(boxPiece(2, 1), boxPiece(1, 1), {0.4, 0.9}), -0.1, precise);
    EXPECT_NEAR(gapOf(boxPiece(2, 1), boxPiece(1, 1), {1.3, 0.1}), -0.2, precise);
    EXPECT_NEAR(gapOf(boxPiece(2, 1), boxPiece(0.1, 0.1), {0.1, 0.2}), -0.35, precise); // deep inside
    EXPECT_NEAR(gapOf(boxPiece(1, 1), boxPiece(1, 1), {0, 0.5 + std::sqrt(0.5) - 0.01}, pi / 4), -0.01,
                precise);
    EXPECT_NEAR(gapOf(boxPiece(4, 0.2), boxPiece(4, 0.2), {}, pi / 2), -2.1, precise); // a cross
    EXPECT_NEAR(gapOf(boxPiece(1, 1), circlePiece(0.2), {0.9, 0.8}), 0.3, precise);    // at a corner
    EXPECT_NEAR(gapOf(boxPiece(1, 1), circlePiece(0.2), {0.4, 0}), -0.3, precise);     // its centre inside
    EXPECT_NEAR(gapOf(boxPiece(1, 1), capsulePiece(2, 0.1), {0, 0.55}), -0.05, precise);
    EXPECT_NEAR(gapOf(boxPiece(1, 1), capsulePiece(2, 0.1), {0, 0.3}), -0.3, precise); // across the whole box
    EXPECT_NEAR(gapOf(capsulePiece(2, 0.1), capsulePiece(2, 0.1), {0, 0.5}), 0.3, precise);
    EXPECT_NEAR(gapOf(capsulePiece(2.2, 0.1), capsulePiece(2.2, 0.1), {0, 0.7}, pi / 2), -0.5, precise);
    EXPECT_NEAR(gapOf(boxPiece(1, 1), boxPiece(1, 1), {1.1, 0}, 0, 0.01), 0.08, precise);
    EXPECT_NEAR(gapOf(boxPiece(1, 1), circlePiece(0.5), {1.1, 0}, 0, 0.01), 0.09, precise);
}

TEST(BruteGap, OfACompoundIsThatOfItsNearestPieces) {
    Shape const fork{{boxPiece(0.1, 1, {-0.5, 0}), boxPiece(0.1, 1, {0.5, 0})}};
    Shape const ball{{circlePiece(0.1)}};
    EXPECT_NEAR(bruteGap({fork, {}, 0}, {ball, {0.1, 0}, 0}), 0.25, 1e-12);
    EXPECT_NEAR(bruteGap({fork, {2, 0}, pi / 2}, {ball, {2, 0.4}, 0}), -0.05, 1e-12);
}

// A displacement of this length separates overlapping pieces, and no shorter one does, in any direction.
TEST(BruteGap, IsTheShortestSeparatingDisplacement) {
    ShapePiece const wedge = polygonPiece({{0, 0}, {0.4, 0.05}, {0.1, 0.4}});
    for (ShapePiece const& other : {boxPiece(0.3, 0.1), capsulePiece(0.5, 0.05), circlePiece(0.1), wedge}) {
        for (int turn = 0; turn < 12; ++turn) {
            Vec2 const at{0.12 + 0.01 * turn, 0.1};
            double const angle = 0.5 * turn;
            double const now = gapOf(wedge, other, at, angle);
            ASSERT_LT(now, 0);
            constexpr int directions = 720;
            double nearestMiss = -1;
            for (int i = 0; i < directions; ++i) {
                Vec2 const way = rotated({1, 0}, 2 * pi * i / directions);
                EXPECT_LE(gapOf(wedge, other, at - 0.999 * now * way, angle), 0);
                nearestMiss = std::max(nearestMiss, gapOf(wedge, other, at - 1.001 * now * way, angle));
            }
            EXPECT_GE(nearestMiss, 0);
        }
    }
}

} // namespace
} // namespace brute_gap_test
} // namespace trembler::test
