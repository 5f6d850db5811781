#include "render/scene/marks/hatch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trembler::render {
namespace {

constexpr double mostLines = 400;

} // namespace

void hatch(Canvas& canvas, std::span<Point const> outline, Point origin, double angle, double spacing,
           Stroke const& stroke) {
    Point const along{std::cos(angle), std::sin(angle)};
    Point const across{-along.y, along.x};
    double first = std::numeric_limits<double>::infinity();
    double last = -first;
    for (Point const corner : outline) {
        first = std::min(first, dot(corner - origin, across));
        last = std::max(last, dot(corner - origin, across));
    }
    if (!(spacing > 0) || !std::isfinite(last - first)) {
        return;
    }
    double const step = spacing * std::max(1.0, std::ceil((last - first) / (spacing * mostLines)));
    std::vector<double> crossings;
    double const start = std::ceil(first / step) * step;
    auto const lines = static_cast<int>((last - start) / step) + 1;
    for (int line = 0; line < lines; ++line) {
        double const height = start + line * step;
        crossings.clear();
        for (std::size_t i = 0; i < outline.size(); ++i) {
            Point const a = outline[i] - origin;
            Point const b = outline[(i + 1) % outline.size()] - origin;
            double const heightA = dot(a, across);
            double const heightB = dot(b, across);
            if ((heightA <= height) != (heightB <= height)) { // a corner counts for one of its two sides
                double const share = (height - heightA) / (heightB - heightA);
                crossings.push_back(dot(a + share * (b - a), along));
            }
        }
        std::sort(crossings.begin(), crossings.end());
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
            Point const base = origin + height * across;
            canvas.line(base + crossings[i] * along, base + crossings[i + 1] * along, stroke);
        }
    }
}

void hatchShape(Canvas& canvas, Shape const& shape, Pose const& pose, float alpha) {
    // The spacing doubles step by step, so that zooming changes the hatching rarely and never fills it to
    // grey.
    double const spacing = 0.09 * std::exp2(std::ceil(std::log2(std::max(1.0, canvas.metres(7) / 0.09))));
    for (ShapePiece const& piece : shape.pieces) {
        std::vector<Point> outline = insetOutline(outlineOf(piece), canvas.metres(2));
        for (Point& corner : outline) {
            corner = toWorld(pose, corner);
        }
        hatch(canvas, outline, pose.at, pose.angle + 0.25 * std::numbers::pi, spacing,
              {.colour = palette::ink, .pixels = 1.2F, .alpha = 0.26F * alpha});
    }
}

} // namespace trembler::render
