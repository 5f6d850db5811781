// Convex pieces of bodies, and where two of them meet: in double precision, relative to one of the bodies, so
// that neither the distance from the world's origin nor a skin around shapes falsifies a contact.
#pragma once

#include "physics/dynamics/core/engine.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace trembler::native {

/// A convex polygon with a rounded outline: a disc has one corner, a capsule two, a polygon 3 to 8 and no
/// radius.
struct Convex {
    int count = 0;
    double radius = 0; ///< m
    std::array<Vec2, maximumCorners>
        corners{}; ///< m, anticlockwise, from the body's centre of mass, in its frame
    std::array<Vec2, maximumCorners> normals{}; ///< outwards, of the side from corner i to corner i + 1
    std::uint32_t piece = 0;                    ///< index within the body

    [[nodiscard]] bool disc() const { return count == 1; }
};

/// The convex pieces of a body's shape, in a fixed order.
[[nodiscard]] std::vector<Convex> convexPieces(BodySpec const& spec);

/// Where a body is, relative to some origin.
struct Pose {
    Vec2 at; ///< m, of the centre of mass
    double cosine = 1;
    double sine = 0;

    [[nodiscard]] Vec2 turn(Vec2 v) const { return {cosine * v.x - sine * v.y, sine * v.x + cosine * v.y}; }
    [[nodiscard]] Vec2 back(Vec2 v) const { return {cosine * v.x + sine * v.y, cosine * v.y - sine * v.x}; }
    [[nodiscard]] Vec2 place(Vec2 v) const { return at + turn(v); }
};

/// One point of a contact. Arms are from the centres of mass, in the world's directions.
struct MeetingPoint {
    Vec2 armA;                 ///< m, to the point that turns with a
    Vec2 armB;                 ///< m
    double separation = 0;     ///< m, along the normal; negative: overlap
    std::uint32_t feature = 0; ///< which corners and sides meet, to recognise the point in the next frame
};

/// The contact of two pieces. On a rounded piece the point of contact lies `radius` beyond the arm's end, in
/// the direction of the normal: that part does not turn with the body, so that a ball may roll by any angle.
struct Meeting {
    Vec2 normal; ///< unit, from a to b
    std::array<MeetingPoint, 2> points{};
    int count = 0;
    bool sideOfA = false; ///< the normal is that of a side of a, not of a corner or of b
    bool sideOfB = false;
};

/// Where the pieces meet if they are at most `margin` (m) apart. `a` and `b` relative to the same origin,
/// which should be near. Method: separating axes of the sides, the nearer feature's side as reference, the
/// other's side clipped to it (as in E. Catto, "Contact manifolds", GDC 2007); two corners that are nearest
/// meet in a single point.
[[nodiscard]] Meeting meet(Convex const& a, Pose const& atA, Convex const& b, Pose const& atB, double margin);

/// A lower bound, in m, of the distance of two pieces, which is exact where sides are nearest and not
/// positive exactly if the pieces overlap.
[[nodiscard]] double gapBetween(Convex const& a, Pose const& atA, Convex const& b, Pose const& atB);

} // namespace trembler::native
