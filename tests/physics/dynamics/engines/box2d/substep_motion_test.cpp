// Bounds on the motion of two bodies against points that move with them, and shapes that are clearly apart
// against Box2D's own contacts.
#include "physics/dynamics/engines/box2d/substep_motion.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trembler {
namespace substep_motion_test {
namespace {

constexpr float limit = 0.01F;

float drawn(float from, float to) {
    return from + (to - from) * static_cast<float>(*rc::gen::inRange(0, 1000001)) / 1e6F;
}

b2Vec2 drawnIn(float reach) {
    return {drawn(-reach, reach), drawn(-reach, reach)};
}

b2Vec2 turnedBy(double angle, b2Vec2 v) {
    double const c = std::cos(angle);
    double const s = std::sin(angle);
    double const x = static_cast<double>(v.x);
    double const y = static_cast<double>(v.y);
    return {static_cast<float>(c * x - s * y), static_cast<float>(s * x + c * y)};
}

// A body that follows a rigid motion about the origin, except for a deviation.
SubstepMotion drawnWith(b2Vec2 shift, float turn, float deviation) {
    SubstepMotion body;
    body.from = drawnIn(2);
    body.extent = drawn(0.05F, 1);
    body.to = shift + turnedBy(static_cast<double>(turn), body.from) + drawnIn(deviation);
    body.turn = turn + drawn(-deviation, deviation);
    return body;
}

// The farthest that a point on the rim of one body moves in the frame of the other.
float farthestPoint(SubstepMotion const& seen, SubstepMotion const& frame) {
    float farthest = 0;
    for (int i = 0; i < 360; ++i) {
        double const angle = i * std::numbers::pi / 180;
        b2Vec2 const rim =
            seen.extent * b2Vec2(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)));
        b2Vec2 const before = seen.from + rim - frame.from;
        b2Vec2 const after = seen.to + turnedBy(static_cast<double>(seen.turn), rim) - frame.to;
        farthest = std::max(farthest, (turnedBy(-static_cast<double>(frame.turn), after) - before).Length());
    }
    return farthest;
}

RC_GTEST_PROP(SubstepMotion, NoPointMovesFartherThanReported, ()) {
    SubstepMotion const a = drawnWith(drawnIn(0.05F), drawn(-0.2F, 0.2F), 0.02F);
    SubstepMotion const b = drawnWith(drawnIn(0.05F), drawn(-0.2F, 0.2F), 0.02F);
    bool const aSmaller = a.extent < b.extent;
    float const farthest = aSmaller ? farthestPoint(a, b) : farthestPoint(b, a);
    if (!movedFarApart(a, b, limit)) {
        RC_ASSERT(farthest <= limit * 1.001F + 2e-4F * 4);
    }
    RC_ASSERT(movedFarApart(a, b, farthest * 0.999F - 2e-4F * 4));
    RC_ASSERT(movedFarApart(a, b, limit) == movedFarApart(b, a, limit) || a.extent == b.extent);
    SubstepMotion const still{b2Vec2_zero, b2Vec2_zero, 0, 2};
    RC_ASSERT(movedFar(a, limit) || farthestPoint(a, still) <= limit * 1.001F);
}

RC_GTEST_PROP(SubstepMotion, BodiesThatDoNotDeviateHaveNotMovedApart, ()) {
    b2Vec2 const shift = drawnIn(0.3F);
    float const turn = drawn(-0.3F, 0.3F);
    float const deviation = *rc::gen::element(0.0F, 0.001F, 0.004F, 0.02F);
    SubstepMotion const reference = drawnWith(shift, turn, deviation);
    SubstepMotion const a = drawnWith(shift, turn, deviation);
    SubstepMotion const b = drawnWith(shift, turn, deviation);
    bool const deviates = deviatesFrom(reference, a, limit) || deviatesFrom(reference, b, limit);
    RC_CLASSIFY(!deviates, "neither deviates");
    if (!deviates && !outOfReach(a, b)) {
        RC_ASSERT(!movedFarApart(a, b, limit * 1.001F + 2e-4F * 4)); // the series' error over a few metres
    }
    if (deviation == 0 && turn * turn < 0.01F) {
        RC_ASSERT(!deviatesFrom(reference, a, 2 * limit)); // else the bound would be useless
    }
}

b2PolygonShape drawnPolygon() {
    b2PolygonShape shape;
    if (*rc::gen::inRange(0, 2) == 0) {
        shape.SetAsBox(drawn(0.02F, 1), drawn(0.02F, 1), drawnIn(0.5F), drawn(-3, 3));
        return shape;
    }
    b2Vec2 corners[3]; // including narrow ones
    float const length = drawn(0.2F, 2);
    float const width = drawn(0.02F, 1);
    corners[0] = {0, 0};
    corners[1] = {length, -width};
    corners[2] = {length, width};
    shape.Set(corners, 3);
    return shape;
}

RC_GTEST_PROP(SubstepMotion, OverlapsAreThoseOfBox2D, ()) {
    b2PolygonShape const a = drawnPolygon();
    b2PolygonShape const b = drawnPolygon();
    b2Transform const atA(drawnIn(0.5F), b2Rot(drawn(-3, 3)));
    b2Rot const turned(drawn(-3, 3));
    // Along a line, so that the pair is seen just before and just after it begins to touch.
    b2Vec2 const direction = turnedBy(static_cast<double>(drawn(-3, 3)), {1, 0});
    Overlap last = Overlap::unknown;
    for (int step = 0; step <= 500; ++step) {
        b2Transform const atB(atA.p + (0.01F * static_cast<float>(step)) * direction, turned);
        b2Manifold manifold;
        b2CollidePolygons(&manifold, &a, atA, &b, atB);
        Overlap const overlap = overlapOf(a, atA, b, atB);
        RC_ASSERT(overlap != Overlap::none || manifold.pointCount == 0);
        // Not by the manifold: Box2D finds no points in some pairs of narrow shapes that overlap.
        RC_ASSERT(overlap != Overlap::certain || b2TestOverlap(&a, 0, &b, 0, atA, atB));
        last = overlap;
        // The extents that a body with this shape would have.
        auto const reach = [](b2PolygonShape const& shape) {
            float farthest = 0;
            for (int i = 0; i < shape.m_count; ++i) {
                farthest = std::max(farthest, shape.m_vertices[i].Length());
            }
            return farthest;
        };
        bool const out = outOfReach({atA.p, atA.p, 0, reach(a)}, {atB.p, atB.p, 0, reach(b)});
        RC_ASSERT(!out || manifold.pointCount == 0);
    }
    RC_ASSERT(last == Overlap::none); // 5 m away, where no two of the shapes meet
}

TEST(SubstepMotion, TheOverlapOfCirclesIsUnknown) {
    b2CircleShape circle;
    circle.m_radius = 0.1F;
    b2PolygonShape box;
    box.SetAsBox(0.1F, 0.1F);
    b2Transform const here({0, 0}, b2Rot(0));
    b2Transform const there({5, 0}, b2Rot(0));
    EXPECT_EQ(overlapOf(box, here, box, there), Overlap::none);
    EXPECT_EQ(overlapOf(box, here, box, here), Overlap::certain);
    EXPECT_EQ(overlapOf(circle, here, box, there), Overlap::unknown); // Box2D's own test is as fast
}

} // namespace
} // namespace substep_motion_test
} // namespace trembler
