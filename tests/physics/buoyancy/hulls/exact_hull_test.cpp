// Area, centroid and moments of the displaced area, compared with a strip integration, and their invariants.
#include "physics/buoyancy/hulls/disc.hpp"
#include "physics/buoyancy/hulls/exact_hull.hpp"
#include "physics/dynamics/properties/shapes/mass_properties.hpp"
#include "tests/physics/buoyancy/generators.hpp"
#include "tests/physics/buoyancy/oracle.hpp"

#include <gtest/gtest.h>

namespace trembler::test {
namespace {

Displacement displaced(ShapePiece const& body, Pose const& pose, ShapePiece const& liquid,
                       Pose const& liquidPose, Vec2 up = {0, 1}) {
    return displacedOf(ExactHull(Shape{{body}}), liquidPieces(Shape{{liquid}}, liquidPose).front(), pose, up);
}

// Moments in the world, from those in the body's frame.
Strips inWorld(AreaMoments const& wet, Pose const& pose) {
    AreaMoments turned;
    turned.area = wet.area;
    turned.first = pose.turned(wet.first);
    double const c = pose.cosine;
    double const s = pose.sine;
    turned.xx = c * c * wet.xx - 2 * c * s * wet.xy + s * s * wet.yy;
    turned.xy = c * s * (wet.xx - wet.yy) + (c * c - s * s) * wet.xy;
    turned.yy = s * s * wet.xx + 2 * c * s * wet.xy + c * c * wet.yy;
    turned = turned.moved(pose.at);
    return {turned.area, turned.area > 0 ? turned.centroid() : Vec2{}, turned.xx, turned.xy, turned.yy};
}

TEST(ExactHull, AgreesWithStripsForAnyConvexPieces) {
    EXPECT_TRUE(rc::check([] {
        ShapePiece const body = *piece();
        ShapePiece liquid = *rc::gen::oneOf(
            convexPolygon(), rc::gen::map(rc::gen::tuple(number(0.2, 4), number(0.2, 4), number(-3, 3)),
                                          [](std::tuple<double, double, double> const& t) {
                                              return boxPiece(std::get<0>(t), std::get<1>(t), {},
                                                              std::get<2>(t));
                                          }));
        Vec2 const at = *point(1);
        double const angle = *number(-4, 4);
        Vec2 const liquidAt = *point(1);
        double const liquidAngle = *number(-4, 4);
        Pose const pose(at, angle);
        Strips const found = inWorld(displaced(body, pose, liquid, Pose(liquidAt, liquidAngle)).wet, pose);
        Strips const expected = common(Slab(body, at, angle), Slab(liquid, liquidAt, liquidAngle));
        // The midpoint rule's error is of the order of (length of the boundary) (strip) at worst where a
        // round end begins, and of its square elsewhere.
        double const tolerance = 2e-6 + 1e-4 * expected.area;
        RC_ASSERT(std::abs(found.area - expected.area) < tolerance);
        RC_ASSERT(length(found.area * found.centroid - expected.area * expected.centroid) < 3 * tolerance);
        RC_ASSERT(std::abs(found.xx - expected.xx) < 9 * tolerance);
        RC_ASSERT(std::abs(found.xy - expected.xy) < 9 * tolerance);
        RC_ASSERT(std::abs(found.yy - expected.yy) < 9 * tolerance);
    }));
}

TEST(ExactHull, TwoLiquidsSideBySideHoldAsMuchAsOne) {
    // For any line that cuts the liquid in two, nothing along it is lost or counted twice.
    EXPECT_TRUE(rc::check([] {
        ShapePiece const body = *piece();
        Pose const pose(*point(1), *number(-4, 4));
        double const tilt = *number(-3, 3);
        double const cut = *number(-2, 2);
        Pose const left(rotated({cut - 10, 0}, tilt), tilt);
        Pose const right(rotated({cut + 10, 0}, tilt), tilt);
        ShapePiece const half = boxPiece(20, 40);
        Displacement const a = displaced(body, pose, half, left);
        Displacement const b = displaced(body, pose, half, right);
        MassProperties const whole = massPropertiesOf(Shape{{body}});
        AreaMoments sum = a.wet;
        sum += b.wet;
        RC_ASSERT(std::abs(sum.area - whole.area) < 1e-12);
        RC_ASSERT(length(sum.centroid() - whole.centre) < 1e-10);
        AreaMoments const own = sum.moved(-sum.centroid());
        RC_ASSERT(std::abs((own.xx + own.yy) / own.area - whole.inertiaPerMass) < 1e-10);
    }));
}

TEST(ExactHull, WaterlineIsTheRateAtWhichTheDisplacedAreaChanges) {
    EXPECT_TRUE(rc::check([] {
        ShapePiece const body = *piece();
        Vec2 const at = *point(0.5);
        double const angle = *number(-4, 4);
        double const tilt = *number(-1, 1);
        Pose const tilted(rotated({0, -20}, tilt), tilt);
        ShapePiece const liquid = boxPiece(60, 40);
        double const d = 1e-5;
        auto const area = [&](Vec2 by, double turn) {
            return displaced(body, Pose(at + by, angle + turn), liquid, tilted).wet.area;
        };
        // Compared along the vertical, for any tilt.
        Waterline const line = displaced(body, Pose(at, angle), liquid, tilted).waterline;
        double const lifting = (area({0, -d}, 0) - area({0, d}, 0)) / (2 * d);
        RC_ASSERT(std::abs(line.length - lifting) < 1e-3);
        // In the liquid's frame. Rotation lifts the parts to the right of the origin: the first moment.
        Vec2 const normal = rotated({0, 1}, tilt);
        Waterline const own = displaced(body, Pose(at, angle), liquid, tilted, normal).waterline;
        double const rising = (area(-d * normal, 0) - area(d * normal, 0)) / (2 * d);
        double const turning = (area({}, -d) - area({}, d)) / (2 * d);
        RC_ASSERT(std::abs(own.length - rising) < 1e-3);
        RC_ASSERT(std::abs(own.first - turning) < 2e-3);
        RC_ASSERT(own.second * own.length >= own.first * own.first * (1 - 1e-9));
    }));
}

TEST(ExactHull, TouchingSidesAreCountedOnce) {
    // A box that stands exactly on the liquid's floor, in its corner, and one as large as the liquid.
    ShapePiece const pool = boxPiece(4, 2);
    EXPECT_NEAR(displaced(boxPiece(1, 1), Pose({-1.5, -0.5}, 0), pool, Pose({}, 0)).wet.area, 1, 1e-14);
    EXPECT_NEAR(displaced(boxPiece(4, 2), Pose({}, 0), pool, Pose({}, 0)).wet.area, 8, 1e-13);
    EXPECT_NEAR(displaced(boxPiece(4, 2), Pose({0, 2}, 0), pool, Pose({}, 0)).wet.area, 0, 1e-14);
    double const quarter = pi / 2;
    EXPECT_NEAR(displaced(boxPiece(2, 4), Pose({}, quarter), pool, Pose({}, 0)).wet.area, 8, 1e-13);
    EXPECT_NEAR(displaced(circlePiece(1), Pose({1, 0}, 0), pool, Pose({}, 0)).wet.area, pi, 1e-14);
}

TEST(ExactHull, DiscSegmentIsItsIntegral) {
    for (double const distance : {-0.999, -0.7, -0.2, 0.0, 0.4, 0.95, 1.0}) {
        double const radius = 0.6;
        Segment const segment = discSegment(radius, distance * radius);
        double area = 0;
        double first = 0;
        double along = 0;
        double across = 0;
        int const count = 200000;
        double const step = (1 + distance) * radius / count;
        for (int i = 0; i < count; ++i) {
            double const x = -radius + (i + 0.5) * step;
            double const half = std::sqrt(radius * radius - x * x);
            area += 2 * half * step;
            first += 2 * half * x * step;
            along += 2 * half * x * x * step;
            across += 2 * half * half * half / 3 * step;
        }
        EXPECT_NEAR(segment.area, area, 1e-7) << distance;
        EXPECT_NEAR(-segment.area * segment.offset, first, 1e-7) << distance;
        EXPECT_NEAR(segment.along, along, 1e-7) << distance;
        EXPECT_NEAR(segment.across, across, 1e-7) << distance;
        EXPECT_NEAR(segment.halfChord, radius * std::sqrt(1 - distance * distance), 1e-12) << distance;
    }
    EXPECT_EQ(discSegment(0.6, -2).area, 0);
    EXPECT_NEAR(discSegment(0.6, 2).area, pi * 0.36, 1e-15);
}

TEST(ExactHull, ADiscAgainstManySidesIsTheSegmentAgainstOne) {
    // A circle at the surface, far from the walls and near to one: both computations must agree.
    ShapePiece const pool = boxPiece(10, 4);
    ShapePiece const disc = circlePiece(0.5);
    for (double const height : {1.6, 1.9, 2.0, 2.3}) {
        Displacement const free = displaced(disc, Pose({0, height}, 0), pool, Pose({}, 0));
        // The wall at x = 5 meets the circle around the body, but cuts off nothing.
        Displacement const near =
            displaced(circlePiece(0.5, {-0.3, 0}), Pose({4.6, height}, 0), pool, Pose({}, 0));
        Displacement const cut = displaced(disc, Pose({4.5 + 1e-13, height}, 0), pool, Pose({}, 0));
        EXPECT_NEAR(free.wet.area, near.wet.area, 1e-14);
        EXPECT_NEAR(free.wet.area, cut.wet.area, 1e-12);
        EXPECT_NEAR(free.wet.first.y, cut.wet.first.y, 1e-12);
        EXPECT_NEAR(free.wet.xx, cut.wet.xx, 1e-12);
        EXPECT_NEAR(free.waterline.length, cut.waterline.length, 1e-6);
    }
}

TEST(ExactHull, RoundLiquidsHaveTheirArea) {
    for (ShapePiece const& liquid : {circlePiece(0.8), capsulePiece(3, 0.8)}) {
        double const area = displaced(boxPiece(10, 10), Pose({}, 0.3), liquid, Pose({0.1, 0.2}, 1)).wet.area;
        EXPECT_NEAR(area, areaOf(liquid), 2e-3 * areaOf(liquid));
    }
}

TEST(ExactHull, CompoundsAreTheSumsOfTheirPieces) {
    Shape const compound{
        {boxPiece(1, 0.2), circlePiece(0.3, {0.5, 0.4}), capsulePiece(1, 0.2, {-0.4, 0.3}, 0.7)}};
    Pose const pose({0.1, 0.05}, 0.4);
    LiquidPiece const pool = liquidPieces(Shape{{boxPiece(20, 10, {0, -5})}}, Pose({}, 0)).front();
    AreaMoments sum;
    for (ShapePiece const& piece : compound.pieces) {
        sum += displacedOf(ExactHull(Shape{{piece}}), pool, pose, {0, 1}).wet;
    }
    AreaMoments const whole = displacedOf(ExactHull(compound), pool, pose, {0, 1}).wet;
    EXPECT_GT(whole.area, 0.1);
    EXPECT_NEAR(whole.area, sum.area, 1e-14);
    EXPECT_NEAR(whole.first.x, sum.first.x, 1e-14);
    EXPECT_NEAR(whole.first.y, sum.first.y, 1e-14);
}

} // namespace
} // namespace trembler::test
