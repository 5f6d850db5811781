// The canvas' lines: wires, rings, arrows and the beads that move along them.
#include "render/draw/canvas.hpp"
#include "render/draw/narrow.hpp"
#include "render/draw/path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace trembler::render {

namespace {

bool usable(std::span<Point const> points) {
    return points.size() >= 2 && std::all_of(points.begin(), points.end(), finite);
}

} // namespace

double Canvas::halfWidth(Stroke const& stroke) const {
    // Never thinner than half a pixel, so that every line can be seen.
    return 0.5 *
           std::max({stroke.width, metres(static_cast<double>(stroke.pixels)), 0.5 / camera_.pixelsPerMetre});
}

void Canvas::addSegments(std::span<Point const> points, double radius, Colour colour, Point shift) {
    for (std::size_t i = 1; i < points.size(); ++i) {
        Point const along = points[i] - points[i - 1];
        double const span = length(along);
        auto shape = placed(0.5 * (points[i] + points[i - 1]) + shift, 0, {0.5 * span + radius, radius});
        if (span > 0) {
            shape.axis = {narrow(along.x / span), narrow(along.y / span)};
        }
        shape.radius = narrow(radius);
        shape.effect = effectFlat;
        shape.colour = packed(colour);
        if (seen(shape, 0)) {
            push(shape);
        }
    }
}

void Canvas::addChain(std::span<Point const> points, Instance look, double radius, double reach,
                      bool underSheet) {
    auto const first = corners_.size();
    for (Point const point : points) {
        corners_.push_back(relative(point));
    }
    auto const segments = points.size() - 1;
    look.kind = kindChain;
    look.radius = narrow(radius);
    for (std::size_t i = 0; i < segments; ++i) {
        Point const along = points[i + 1] - points[i];
        double const span = length(along);
        auto shape = look;
        shape.centre = relative(0.5 * (points[i] + points[i + 1]));
        shape.half = {narrow(0.5 * span + radius), narrow(radius)};
        if (span > 0) {
            shape.axis = {narrow(along.x / span), narrow(along.y / span)};
        }
        if (!seen(shape, reach)) {
            continue;
        }
        // Every segment checks its neighbours as far along the path as the light reaches, but not further, to
        // save time.
        auto from = i;
        auto to = i + 1;
        double left = reach + radius;
        while (from > 0 && left > 0 && i - from < 24) {
            left -= length(points[from] - points[from - 1]);
            --from;
        }
        left = reach + radius;
        while (to < segments && left > 0 && to - i < 24) {
            left -= length(points[to + 1] - points[to]);
            ++to;
        }
        shape.params = {static_cast<float>(first + from), static_cast<float>(first + to),
                        static_cast<float>(first + i), 0.F};
        (underSheet ? shadows_ : shapes_).push_back(shape);
    }
}

void Canvas::polyline(std::span<Point const> points, Stroke const& stroke) {
    if (!usable(points)) {
        return;
    }
    double const radius = halfWidth(stroke);
    double const rim = std::min(metres(static_cast<double>(stroke.outline)), 0.45 * radius);
    if (options_.shadows && stroke.height > 0.F) {
        double const distance = static_cast<double>(stroke.height) * metres(3);
        std::vector<Point> moved(points.begin(), points.end());
        for (auto& point : moved) {
            point = point + Point{0.5 * distance, -0.866 * distance};
        }
        Instance look;
        look.effect = effectShadow;
        look.outline = narrow(1.3 * distance);
        look.colour = packed(faded(palette::shadow, stroke.alpha));
        addChain(moved, look, radius, 1.3 * distance, !stroke.onBody);
    }
    if (stroke.glow.reach > 0 && std::isfinite(stroke.glow.reach)) {
        Instance look;
        look.effect = effectGlow;
        look.outline = narrow(stroke.glow.reach);
        look.colour = packed(faded(stroke.glow.colour, stroke.glow.strength * stroke.alpha));
        addChain(points, look, radius, stroke.glow.reach, false);
    }
    bool const opaque =
        stroke.alpha >= 1.F && stroke.colour.alpha == 255 && stroke.outlineColour.alpha == 255;
    if (!opaque) {
        Instance look;
        look.effect = effectFlat;
        look.outline = narrow(rim);
        look.colour = packed(faded(stroke.colour, stroke.alpha));
        look.edge = packed(faded(stroke.outlineColour, stroke.alpha));
        addChain(points, look, radius, 0, false);
        return;
    }
    if (rim > 0) {
        addSegments(points, radius, stroke.outlineColour, {});
    }
    if (!stroke.round) {
        addSegments(points, radius - rim, stroke.colour, {});
        return;
    }
    // A tube in three flat passes: shading each segment by itself would show every joint.
    double const inner = radius - rim;
    addSegments(points, inner, mix(stroke.colour, palette::ink, 0.28F), {});
    addSegments(points, 0.72 * inner, stroke.colour, {-0.14 * inner, 0.24 * inner});
    addSegments(points, 0.22 * inner, mix(stroke.colour, rgb(0xFFFFFF), 0.55F),
                {-0.20 * inner, 0.34 * inner});
}

void Canvas::line(Point a, Point b, Stroke const& stroke) {
    std::array const points{a, b};
    polyline(points, stroke);
}

void Canvas::strokeShape(Instance shape, Stroke const& stroke, double halfWidth) {
    if (!seen(shape, std::max(stroke.glow.reach, metres(12)))) {
        return;
    }
    addShadow(shape, stroke.height, stroke.alpha, stroke.onBody);
    addGlow(shape, stroke.glow, stroke.alpha);
    shape.effect = stroke.round ? effectSolid : effectFlat;
    shape.outline = narrow(std::min(metres(static_cast<double>(stroke.outline)), 0.45 * halfWidth));
    shape.colour = packed(faded(stroke.colour, stroke.alpha));
    shape.edge = packed(faded(stroke.outlineColour, stroke.alpha));
    push(shape);
}

void Canvas::ring(Point centre, double radius, Stroke const& stroke) {
    arc(centre, radius, 0, 2 * std::numbers::pi, stroke);
}

void Canvas::arc(Point centre, double radius, double from, double sweep, Stroke const& stroke) {
    double const half = halfWidth(stroke);
    if (!(radius > 0) || !std::isfinite(from) || !std::isfinite(sweep)) {
        return;
    }
    double const turned = std::min(std::abs(sweep), 2 * std::numbers::pi);
    double const middle = std::remainder(from + 0.5 * sweep, 2 * std::numbers::pi);
    auto shape = placed(centre, middle, {radius + half, radius + half});
    shape.kind = kindArc;
    // A full ring must have no end, not even by rounding.
    bool const full = turned >= 2 * std::numbers::pi;
    shape.params = {narrow(radius), narrow(half), full ? -2.F : narrow(std::cos(0.5 * turned)),
                    full ? 0.F : narrow(std::sin(0.5 * turned))};
    strokeShape(shape, stroke, half);
}

void Canvas::arrow(Point from, Point to, Stroke const& stroke) {
    Point const along = to - from;
    double const span = length(along);
    if (!(span > 0) || !std::isfinite(span)) {
        return;
    }
    double const half = halfWidth(stroke);
    double const headLength = std::min(6.4 * half, 0.8 * span);
    double const headHalf = 0.46 * headLength;
    double const shaft = std::min(half, 0.5 * headHalf);
    // In the arrow's own frame, the tip at the right.
    double const right = 0.5 * span;
    std::array const corners{
        Point{-right, -shaft}, Point{right - headLength, -shaft},   Point{right - headLength, -headHalf},
        Point{right, 0},       Point{right - headLength, headHalf}, Point{right - headLength, shaft},
        Point{-right, shaft}};
    auto shape = placed(0.5 * (from + to), std::atan2(along.y, along.x), {right, headHalf});
    shape.kind = kindPolygon;
    shape.params = {static_cast<float>(corners_.size()), static_cast<float>(corners.size()), 0.F, 0.F};
    for (Point const corner : corners) {
        corners_.push_back({narrow(corner.x), narrow(corner.y)});
    }
    strokeShape(shape, stroke, shaft);
}

void Canvas::beads(std::span<Point const> path, double spacing, double phase, double radius, Colour colour) {
    double const total = usable(path) ? pathLength(path) : 0;
    if (!(total > 0) || !(spacing > 0) || !std::isfinite(phase)) {
        return;
    }
    // However small the spacing and long the path, the number of beads stays bounded.
    double const step = std::max({spacing, 1 / camera_.pixelsPerMetre, total / 5000});
    Style const bead{.tint = colour, .outline = 0.F, .height = 0.F};
    double const first = (phase - std::floor(phase)) * step;
    auto const count = static_cast<int>(std::floor((total - first) / step)) + 1;
    for (int i = 0; i < count; ++i) {
        circle({pointAlong(path, first + i * step), 0}, radius, bead);
    }
}

} // namespace trembler::render
