// Geometry of shapes as drawing and picking need it: outlines, distances, extents, cuts.
#pragma once

#include "physics/dynamics/properties/shape.hpp"
#include "physics/dynamics/properties/shapes/mass_properties.hpp"
#include "render/draw/camera.hpp"
#include "render/draw/geometry.hpp"

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace trembler::render {

[[nodiscard]] constexpr Point toPoint(Vec2 v) {
    return {v.x, v.y};
}

/// A rectangle along the axes, metres; empty at first.
struct Extent {
    Point lower{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    Point upper{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

    [[nodiscard]] bool empty() const { return !(lower.x <= upper.x && lower.y <= upper.y); }
    [[nodiscard]] Point centre() const { return 0.5 * (lower + upper); }
    [[nodiscard]] Point half() const { return 0.5 * (upper - lower); }
    /// Points that are not finite are ignored.
    void add(Point point);
    void add(Extent const& other);
    /// Larger by `margin` metres on all sides; an empty one stays empty.
    [[nodiscard]] Extent widened(double margin) const;
    [[nodiscard]] bool overlaps(Extent const& other) const;
    [[nodiscard]] bool contains(Point point) const {
        return point.x >= lower.x && point.x <= upper.x && point.y >= lower.y && point.y <= upper.y;
    }
};

/// The part of the world that a camera shows.
[[nodiscard]] Extent viewOf(Camera const& camera);

/// Where a piece lies in its object's frame.
[[nodiscard]] Pose poseIn(ShapePiece const& piece);

/// The piece's edge in its object's frame, anticlockwise; a whole circle gets `roundness` corners (8 to 62).
[[nodiscard]] std::vector<Point> outlineOf(ShapePiece const& piece, int roundness = 40);

/// Distance in metres from a point of the object's frame to the edge, negative inside. Exact.
[[nodiscard]] double distanceTo(ShapePiece const& piece, Point local);
/// The least distance to any piece: exact outside, and its sign is right inside. Infinite without pieces.
[[nodiscard]] double distanceTo(Shape const& shape, Point local);

/// The smallest rectangle around the shape in the world. Exact.
[[nodiscard]] Extent extentOf(ShapePiece const& piece, Pose const& body);
[[nodiscard]] Extent extentOf(Shape const& shape, Pose const& body);

/// Centre of mass of an even density, in the object's frame.
[[nodiscard]] inline Point centroidOf(Shape const& shape) {
    return toPoint(centreOfMass(shape));
}

/// The part of a line inside a convex outline: from and to, in order of `direction`; nothing if they do not
/// meet.
[[nodiscard]] std::optional<std::array<Point, 2>> clipLine(std::span<Point const> convex, Point at,
                                                           Point direction);
/// The part of a convex outline on the side of the line through `at` to which `normal` points; may be empty.
[[nodiscard]] std::vector<Point> clipHalf(std::span<Point const> convex, Point at, Point normal);

/// A convex outline with every side moved inwards by `distance` metres; empty if nothing is left.
[[nodiscard]] std::vector<Point> insetOutline(std::span<Point const> convex, double distance);

/// The point of a body's edge that is nearest to `target`; all in the object's frame. {0, 0} without pieces.
[[nodiscard]] Point nearestOnEdge(Shape const& shape, Point target);

/// A point of the world, in the frame of a pose.
[[nodiscard]] Point toLocal(Pose const& pose, Point world);

} // namespace trembler::render
