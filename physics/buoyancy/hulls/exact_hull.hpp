// Detail level "exact": area and centroid of the submerged polygon, circles by circular segment.
#pragma once

#include "physics/buoyancy/hulls/hull.hpp"

#include <optional>

namespace trembler {

/// Boxes and polygons are clipped by the liquid's sides; circles are cut into a circular segment by one side,
/// and intersected with the polygon of all of them otherwise; a capsule is a box and two half discs.
class ExactHull final : public Hull {
public:
    /// The shape must be valid (see faultIn()).
    explicit ExactHull(Shape const& shape);
    [[nodiscard]] Displacement displaced(std::span<Side const> sides, Vec2 up) const override;

private:
    struct Disc {
        Vec2 centre;
        double radius = 0;
        std::optional<Side> flat; // of a half disc: the side that it lies inside of
    };
    [[nodiscard]] static Displacement polygonDisplaced(std::span<Vec2 const> corners,
                                                       std::span<Side const> sides, Vec2 up);
    [[nodiscard]] static Displacement discDisplaced(Disc const& disc, std::span<Side const> sides, Vec2 up);
    [[nodiscard]] static Displacement manySided(Disc const& disc, std::span<Side const> sides, Vec2 up);

    std::vector<std::vector<Vec2>> polygons_;
    std::vector<Disc> discs_;
};

/// Moments of a whole shape about its origin, exact for round pieces.
[[nodiscard]] AreaMoments shapeMoments(Shape const& shape);
/// Radius (m) of a circle around the origin that holds the shape.
[[nodiscard]] double reachOf(Shape const& shape);

} // namespace trembler
