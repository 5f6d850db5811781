// The motion of bodies within a substep, and whether parts of two bodies can have moved relative to each
// other by more than a limit. In Box2D's units. Called for each contact of a scene, hence inline.
#pragma once

#include <box2d/box2d.h>

#include <cmath>

namespace trembler {

struct SubstepMotion {
    b2Vec2 from = b2Vec2_zero; ///< the body's centre at the beginning
    b2Vec2 to = b2Vec2_zero;   ///< and at the end
    float turn = 0;            ///< rad
    float extent = 0;          ///< the distance of its farthest point from its centre, or a little more
};

/// By b2CollidePolygons(), two polygons touch if a point of one lies within the sum of their skins before a
/// face of the other, and no farther beyond the face's ends: at most √2 times that sum, and rounding.
inline constexpr float skinFactor = 1.5F;

/// Whether |way| + |turn| * extent > limit.
[[nodiscard]] inline bool exceeds(b2Vec2 way, float turn, float extent, float limit) {
    float const rest = limit - std::abs(turn) * extent;
    return rest < 0 || way.LengthSquared() > rest * rest;
}

/// The distance between a body's place at the end and the place where it would be if it had moved with the
/// reference.
[[nodiscard]] inline b2Vec2 deviationFrom(SubstepMotion const& reference, SubstepMotion const& body) {
    // Nearly all bodies turn by little in a substep: the series are exact to 2e-4 of a distance.
    bool const little = std::abs(reference.turn) < 0.1F;
    b2Rot turned;
    turned.s = little ? reference.turn : std::sin(reference.turn);
    turned.c = little ? 1 - reference.turn * reference.turn / 2 : std::cos(reference.turn);
    return body.to - reference.to - b2Mul(turned, body.from - reference.from);
}

/// Whether any point of the body may have moved farther than `limit`.
[[nodiscard]] inline bool movedFar(SubstepMotion const& body, float limit) {
    return exceeds(body.to - body.from, body.turn, body.extent, limit);
}

/// Whether any point of the smaller body may have moved farther than `limit` in the frame of the larger one.
[[nodiscard]] inline bool movedFarApart(SubstepMotion const& a, SubstepMotion const& b, float limit) {
    SubstepMotion const& large = a.extent < b.extent ? b : a;
    SubstepMotion const& small = a.extent < b.extent ? a : b;
    return exceeds(deviationFrom(large, small), small.turn - large.turn, small.extent, limit);
}

/// A bound for movedFarApart() of two bodies within reach of each other, by the motion of each in the frame
/// of a third body: if neither deviates by more than half of the limit from the third's motion, they have not
/// moved apart by more than the limit. For a rotating drum one pass over all bodies replaces a test of all
/// pairs in it.
[[nodiscard]] inline bool deviatesFrom(SubstepMotion const& reference, SubstepMotion const& body,
                                       float limit) {
    // Let e be the deviation of a body and t its turn beyond the reference's. The smaller one of two bodies
    // has moved in the frame of the larger one by at most |e_s| + |e_l| + |t_l| d + |t_s - t_l| r_s, where d
    // is the distance of their centres at the beginning and r the extents. If they are within reach at either
    // time, d <= r_s + r_l + skins + |e_s| + |e_l|; and r_s <= r_l.
    float const margin = skinFactor * 2 * b2_polygonRadius + limit;
    return exceeds(deviationFrom(reference, body), body.turn - reference.turn, 3 * body.extent + margin,
                   limit / 2);
}

/// Whether two bodies are so far from each other, at the beginning and at the end, that they do not touch.
[[nodiscard]] inline bool outOfReach(SubstepMotion const& a, SubstepMotion const& b) {
    float const reach = a.extent + b.extent + skinFactor * 2 * b2_polygonRadius;
    return b2DistanceSquared(a.to, b.to) > reach * reach && b2DistanceSquared(a.from, b.from) > reach * reach;
}

enum class Overlap : unsigned char {
    none,    ///< so far from each other that they do not touch
    certain, ///< they have points in common
    unknown, ///< needs b2Contact::Evaluate()
};

/// A quick test of two shapes, several times faster than b2Contact::Evaluate().
[[nodiscard]] Overlap overlapOf(b2Shape const& a, b2Transform const& atA, b2Shape const& b,
                                b2Transform const& atB);

} // namespace trembler
