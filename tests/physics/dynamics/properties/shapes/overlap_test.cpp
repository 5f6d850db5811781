// Whether shapes overlap by more than is allowed, against their gap by every corner and side.
#include "physics/dynamics/properties/shapes/overlap.hpp"
#include "tests/physics/buoyancy/generators.hpp"
#include "tests/physics/dynamics/brute_gap.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>

namespace trembler::test {
namespace overlap_test {
namespace {

Shape anyShape() {
    Shape shape;
    for (int i = *rc::gen::inRange(1, 4); i > 0; --i) {
        shape.pieces.push_back(*piece());
    }
    return shape;
}

TEST(Overlap, IsThatOfTheGapBetweenShapes) {
    EXPECT_TRUE(rc::check("apart: no; by more than is allowed: yes", [] {
        Shape const a = anyShape();
        Shape const b = anyShape();
        PlacedShape const first{a, *point(500), *number(-3, 3)};
        PlacedShape const second{b, first.at + *point(2), *number(-3, 3)};
        double const gap =
            bruteGap({first.shape, first.at, first.angle}, {second.shape, second.at, second.angle});
        double const rounding = 1e-4; // of single precision
        RC_CLASSIFY(gap > 0, "apart");
        if (gap > rounding) {
            RC_ASSERT(!overlap(first, second, 0));
        } else if (gap < -rounding) {
            RC_ASSERT(overlap(first, second, 0));
        }
        RC_ASSERT(overlap(first, second, 0) == overlap(second, first, 0) || std::abs(gap) < rounding);
        // The limit accepts shapes that overlap by less, and rejects shapes that overlap by more.
        double const allowed = *number(0.001, 0.02);
        if (gap > -allowed * 0.4) {
            RC_ASSERT(!overlap(first, second, allowed) || gap < -rounding);
        }
        if (gap < -2 * allowed - rounding) {
            RC_ASSERT(overlap(first, second, allowed));
        }
    }));
}

TEST(Overlap, OfSinglePiecesBeginsAtTheAllowedDepth) {
    Shape const box{{boxPiece(1, 1)}};
    Shape const ball{{circlePiece(0.5)}};
    for (Shape const* const other : {&box, &ball}) {
        EXPECT_FALSE(overlap({box, {}, 0}, {*other, {1.001, 0}, 0}, 0));
        EXPECT_TRUE(overlap({box, {}, 0}, {*other, {0.999, 0}, 0}, 0));
        EXPECT_FALSE(overlap({box, {}, 0}, {*other, {0.991, 0}, 0}, 0.01));
        EXPECT_TRUE(overlap({box, {}, 0}, {*other, {0.989, 0}, 0}, 0.01));
        EXPECT_FALSE(overlap({box, {1e6, 0}, 0}, {*other, {1e6 + 1.001, 0}, 0}, 0)) << "far out";
    }
    // A hole between pieces is a hole.
    Shape const fork{{boxPiece(0.1, 1, {-0.5, 0}), boxPiece(0.1, 1, {0.5, 0})}};
    Shape const marble{{circlePiece(0.4)}};
    EXPECT_FALSE(overlap({fork, {}, 0}, {marble, {}, 0}, 0));
    EXPECT_TRUE(overlap({fork, {}, 0}, {marble, {0.06, 0}, 0}, 0));
    EXPECT_FALSE(overlap({Shape{}, {}, 0}, {box, {}, 0}, 0)) << "nothing overlaps with nothing";
}

TEST(Overlap, ExtentIsTheSmallestUprightRectangle) {
    EXPECT_TRUE(rc::check("walls just outside do not touch, walls just inside do", [] {
        Shape const shape = anyShape();
        PlacedShape const placed{shape, *point(20), *number(-3, 3)};
        auto const [lower, upper] = extentOf(placed);
        Vec2 const middle = 0.5 * (lower + upper);
        Shape const wall{{boxPiece(1, 200)}};
        Shape const floor{{boxPiece(200, 1)}};
        for (double const sign : {-1.0, 1.0}) {
            double const x = sign < 0 ? lower.x : upper.x;
            double const y = sign < 0 ? lower.y : upper.y;
            double const gapX =
                bruteGap({shape, placed.at, placed.angle}, {wall, {x + sign * 0.5, middle.y}, 0});
            double const gapY =
                bruteGap({shape, placed.at, placed.angle}, {floor, {middle.x, y + sign * 0.5}, 0});
            RC_ASSERT(std::abs(gapX) < 1e-9);
            RC_ASSERT(std::abs(gapY) < 1e-9);
        }
    }));
}

} // namespace
} // namespace overlap_test
} // namespace trembler::test
