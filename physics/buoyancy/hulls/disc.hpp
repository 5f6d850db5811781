// Area, moments and cuts of discs.
#pragma once

#include "physics/buoyancy/properties/moments.hpp"

#include <array>

namespace trembler {

/// The moments of a whole disc about its centre.
[[nodiscard]] AreaMoments discMoments(double radius);

/// The moments, about its centre, of the sector of a disc from the direction of p to that of q, the shorter
/// way round; negative if that is clockwise. Neither p nor q may be zero.
[[nodiscard]] AreaMoments sectorMoments(double radius, Vec2 p, Vec2 q);

/// The part of a disc on the inner side of a straight line: the circular segment.
struct Segment {
    double area = 0;      ///< m²
    double offset = 0;    ///< m, from the disc's centre to the segment's centroid, against the line's normal
    double halfChord = 0; ///< m, of the cut
    double along = 0;     ///< m⁴, second moment about the centre along the normal
    double across = 0;    ///< m⁴, second moment about the centre across the normal

    /// About the disc's centre, with the line's outward normal.
    [[nodiscard]] AreaMoments moments(Vec2 normal) const;
};

/// `distance` (m) is that of the line from the centre, in the direction of its outward normal: at -radius or
/// less nothing of the disc is inside, at radius or more all of it.
[[nodiscard]] Segment discSegment(double radius, double distance);

/// The contribution of a polygon's side to the intersection of polygon and disc.
struct DiscSide {
    AreaMoments moments;       ///< of (centre, from, to) within the disc, about the centre
    std::array<Vec2, 2> chord; ///< the part of the side within the disc, relative to the centre
    bool cuts = false;         ///< whether the side has such a part
};

/// The part of the triangle (centre, from, to) that lies within the disc, negative if it runs clockwise; from
/// and to are relative to the centre. The sum over the sides of a polygon is the intersection of polygon and
/// disc; every term is continuous in its arguments, so nothing depends on which side of a corner rounding
/// puts a point.
[[nodiscard]] DiscSide discSide(double radius, Vec2 from, Vec2 to);

} // namespace trembler
