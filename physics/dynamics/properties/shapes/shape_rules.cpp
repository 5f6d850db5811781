#include "physics/dynamics/properties/shapes/shape_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trembler {
namespace {

using Fault = std::optional<std::string>;

constexpr double leastTurn = 1e-3; // sine of the least turn at a corner, about 0.06 degrees

Fault faultInMeasure(double value, double minimum, double maximum, std::string_view what) {
    if (!std::isfinite(value) || value < minimum || value > maximum) {
        return fmt::format("its {} is {} m; expected {} to {} m", what, value, minimum, maximum);
    }
    return std::nullopt;
}

Fault faultInCorners(std::vector<Vec2> const& corners) {
    std::size_t const count = corners.size();
    if (count < 3 || count > maximumCorners) {
        return fmt::format("its polygon has {} corners; expected 3 to {} (a compound can have more pieces)",
                           count, maximumCorners);
    }
    for (Vec2 const corner : corners) {
        if (!isFinite(corner) || std::abs(corner.x) > 1e3 || std::abs(corner.y) > 1e3) {
            return fmt::format("a corner of its polygon is [{}, {}]; expected numbers from -1000 to 1000 m",
                               corner.x, corner.y);
        }
    }
    double turned = 0;
    std::size_t right = 0;
    for (std::size_t i = 0; i < count; ++i) {
        Vec2 const here = corners[(i + 1) % count];
        Vec2 const in = here - corners[i];
        Vec2 const out = corners[(i + 2) % count] - here;
        if (length(in) < minimumExtent) {
            return fmt::format("corners {} and {} of its polygon are {} m apart; expected at least {} m",
                               i + 1, (i + 1) % count + 1, length(in), minimumExtent);
        }
        double const sine = cross(in, out);
        double const scale = length(in) * length(out);
        if (std::abs(sine) < leastTurn * scale && dot(in, out) > 0) {
            return fmt::format(
                "corner {} of its polygon, [{}, {}], lies on the line between its neighbours; leave "
                "it out",
                (i + 1) % count + 1, here.x, here.y);
        }
        right += sine < 0 ? 1U : 0U;
        turned += std::atan2(sine, dot(in, out));
    }
    if (right == count) {
        return "the corners of its polygon run clockwise; expected anticlockwise: turn their order round";
    }
    if (right != 0 || turned > 2 * pi + 1e-6) {
        return "its polygon is not convex; expected a convex one, or several convex pieces";
    }
    for (std::size_t i = 0; i < count; ++i) {
        Vec2 const side = corners[(i + 1) % count] - corners[i];
        double height = 0;
        for (Vec2 const corner : corners) {
            height = std::max(height, cross(side, corner - corners[i]) / length(side));
        }
        if (height < minimumExtent) {
            return fmt::format("its polygon is {} m thin; expected at least {} m", height, minimumExtent);
        }
    }
    return std::nullopt;
}

Fault faultIn(ShapePiece const& piece) {
    bool const placed = isFinite(piece.at) && std::abs(piece.at.x) <= 1e3 && std::abs(piece.at.y) <= 1e3;
    if (!placed || !(std::abs(piece.angle) <= 1e3)) {
        return fmt::format("it lies at [{}, {}] m, turned by {} rad; expected numbers from -1000 to 1000",
                           piece.at.x, piece.at.y, piece.angle);
    }
    switch (piece.form) {
    case ShapeForm::circle:
        return faultInMeasure(piece.radius, minimumExtent / 2, 1e3, "radius");
    case ShapeForm::box:
        if (Fault fault = faultInMeasure(piece.width, minimumExtent, 1e4, "width")) {
            return fault;
        }
        return faultInMeasure(piece.height, minimumExtent, 1e4, "height");
    case ShapeForm::capsule:
        if (Fault fault = faultInMeasure(piece.radius, minimumExtent / 2, 1e3, "radius")) {
            return fault;
        }
        if (Fault fault = faultInMeasure(piece.width, minimumExtent, 1e4, "width")) {
            return fault;
        }
        if (piece.width < 2 * piece.radius) {
            return fmt::format(
                "it is a capsule {} m long with ends of {} m radius; expected it to be at least as "
                "long as both ends, {} m",
                piece.width, piece.radius, 2 * piece.radius);
        }
        return std::nullopt;
    case ShapeForm::polygon:
        return faultInCorners(piece.corners);
    }
    return "it has an unknown form; expected circle, box, polygon or capsule";
}

} // namespace

Fault faultIn(Shape const& shape) {
    if (shape.pieces.empty() || shape.pieces.size() > maximumPieces) {
        return fmt::format("the shape has {} pieces; expected 1 to {}", shape.pieces.size(), maximumPieces);
    }
    for (std::size_t i = 0; i < shape.pieces.size(); ++i) {
        if (Fault const fault = faultIn(shape.pieces[i])) {
            return fmt::format("piece {} of the shape: {}", i + 1, *fault);
        }
    }
    return std::nullopt;
}

} // namespace trembler
