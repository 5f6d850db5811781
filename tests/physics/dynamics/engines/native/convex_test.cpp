// Meetings against distances found by sampling the outlines.
#include "physics/dynamics/engines/native/convex.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <numbers>

namespace trembler::native {
namespace convex_test {
namespace {

double number() {
    return *rc::gen::inRange(-1000000, 1000001) / 1e6;
}

Convex boxOf(double width, double height) {
    Shape shape;
    shape.pieces.push_back(boxPiece(width, height));
    BodySpec spec;
    spec.shape = &shape;
    spec.spread = massPropertiesOf(shape);
    return convexPieces(spec).at(0);
}
Convex discOf(double radius) {
    Shape shape;
    shape.pieces.push_back(circlePiece(radius));
    BodySpec spec;
    spec.shape = &shape;
    spec.spread = massPropertiesOf(shape);
    return convexPieces(spec).at(0);
}

Pose poseAt(Vec2 at, double angle) {
    return {at, std::cos(angle), std::sin(angle)};
}

// The least distance of two outlines, corners against sides, which is the distance of two convex polygons
// that are apart.
double sampled(Convex const& a, Pose const& atA, Convex const& b, Pose const& atB) {
    double least = 1e300;
    auto const nearest = [&](Convex const& x, Pose const& atX, Convex const& y, Pose const& atY) {
        for (std::size_t i = 0; i < static_cast<std::size_t>(x.count); ++i) {
            Vec2 const corner = atX.place(x.corners[i]);
            for (std::size_t j = 0; j < static_cast<std::size_t>(y.count); ++j) {
                Vec2 const from = atY.place(y.corners[j]);
                Vec2 const side = atY.place(y.corners[(j + 1) % static_cast<std::size_t>(y.count)]) - from;
                double const whole = lengthSquared(side);
                double const t = whole > 0 ? std::clamp(dot(corner - from, side) / whole, 0.0, 1.0) : 0;
                least = std::min(least, length(corner - from - t * side));
            }
        }
    };
    nearest(a, atA, b, atB);
    nearest(b, atB, a, atA);
    return least - a.radius - b.radius;
}

TEST(Convex, MeetsAtTheDistanceOfTheOutlines) {
    EXPECT_TRUE(rc::check([] {
        Convex const a = *rc::gen::arbitrary<bool>()
                             ? discOf(0.1 + 0.4 * std::abs(number()))
                             : boxOf(0.2 + std::abs(number()), 0.2 + std::abs(number()));
        Convex const b = *rc::gen::arbitrary<bool>()
                             ? discOf(0.1 + 0.4 * std::abs(number()))
                             : boxOf(0.2 + std::abs(number()), 0.2 + std::abs(number()));
        Pose const atA = poseAt({0, 0}, std::numbers::pi * number());
        Pose const atB = poseAt({2.5 * number(), 2.5 * number()}, std::numbers::pi * number());
        double const distance = sampled(a, atA, b, atB);
        RC_PRE(gapBetween(a, atA, b, atB) > 1e-3);
        Meeting const meeting = meet(a, atA, b, atB, 5);
        RC_ASSERT(meeting.count > 0);
        double least = 1e300;
        for (std::size_t i = 0; i < static_cast<std::size_t>(meeting.count); ++i) {
            least = std::min(least, meeting.points[i].separation);
        }
        RC_ASSERT(std::abs(least - distance) < 1e-9);
        RC_ASSERT(std::abs(length(meeting.normal) - 1) < 1e-12);
        RC_ASSERT(gapBetween(a, atA, b, atB) <= distance + 1e-9);
    }));
}

// Moving b by the separation along the normal brings it into touch.
TEST(Convex, ItsNormalLeadsOutOfAnOverlap) {
    EXPECT_TRUE(rc::check([] {
        Convex const a = boxOf(0.4 + std::abs(number()), 0.4 + std::abs(number()));
        Convex const b = boxOf(0.4 + std::abs(number()), 0.4 + std::abs(number()));
        Pose const atA = poseAt({0, 0}, std::numbers::pi * number());
        Pose atB = poseAt({0.5 * number(), 0.5 * number()}, std::numbers::pi * number());
        RC_PRE(gapBetween(a, atA, b, atB) < 0);
        Meeting const meeting = meet(a, atA, b, atB, 0);
        RC_ASSERT(meeting.count > 0);
        double deepest = 0;
        for (std::size_t i = 0; i < static_cast<std::size_t>(meeting.count); ++i) {
            deepest = std::min(deepest, meeting.points[i].separation);
        }
        atB.at -= deepest * meeting.normal;
        RC_ASSERT(std::abs(gapBetween(a, atA, b, atB)) < 1e-3);
    }));
}

} // namespace
} // namespace convex_test
} // namespace trembler::native
