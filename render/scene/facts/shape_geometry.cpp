#include "render/scene/facts/shape_geometry.hpp"

#include <algorithm>
#include <numbers>

namespace trembler::render {
namespace {

double crossOf(Point a, Point b) {
    return a.x * b.y - a.y * b.x;
}

double halfSegment(ShapePiece const& capsule) {
    return std::max(0.0, 0.5 * capsule.width - capsule.radius);
}

std::vector<Point> roundOutline(double half, double radius, int roundness) {
    int const perEnd = std::clamp(roundness, 8, 62) / 2;
    std::vector<Point> points;
    for (int end = 0; end < 2; ++end) {
        double const start = (end == 0 ? -0.5 : 0.5) * std::numbers::pi;
        // A circle's second half must not repeat the points in which the halves meet.
        int const count = half > 0 ? perEnd : perEnd - 1;
        for (int i = 0; i <= count; ++i) {
            double const angle = start + std::numbers::pi * i / perEnd;
            points.push_back(
                {(end == 0 ? half : -half) + radius * std::cos(angle), radius * std::sin(angle)});
        }
    }
    return points;
}

double polygonDistance(std::span<Vec2 const> corners, Point p) {
    if (corners.empty()) {
        return std::numeric_limits<double>::infinity();
    }
    double nearest = std::numeric_limits<double>::infinity();
    bool inside = true;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        Point const a = toPoint(corners[i]);
        Point const b = toPoint(corners[(i + 1) % corners.size()]);
        Point const edge = b - a;
        double const t = std::clamp(dot(p - a, edge) / std::max(dot(edge, edge), 1e-300), 0.0, 1.0);
        nearest = std::min(nearest, length(p - a - t * edge));
        inside = inside && crossOf(edge, p - a) >= 0;
    }
    return inside ? -nearest : nearest;
}

} // namespace

void Extent::add(Point point) {
    if (finite(point)) {
        lower = {std::min(lower.x, point.x), std::min(lower.y, point.y)};
        upper = {std::max(upper.x, point.x), std::max(upper.y, point.y)};
    }
}

void Extent::add(Extent const& other) {
    if (!other.empty()) {
        add(other.lower);
        add(other.upper);
    }
}

Extent Extent::widened(double margin) const {
    if (empty()) {
        return *this;
    }
    return {lower - Point{margin, margin}, upper + Point{margin, margin}};
}

bool Extent::overlaps(Extent const& other) const {
    return lower.x <= other.upper.x && other.lower.x <= upper.x && lower.y <= other.upper.y &&
           other.lower.y <= upper.y;
}

Extent viewOf(Camera const& camera) {
    Point const half{0.5 * camera.viewport.width / camera.pixelsPerMetre,
                     0.5 * camera.viewport.height / camera.pixelsPerMetre};
    Extent view;
    view.add(camera.centre - half);
    view.add(camera.centre + half);
    return view;
}

Pose poseIn(ShapePiece const& piece) {
    return {toPoint(piece.at), piece.angle};
}

std::vector<Point> outlineOf(ShapePiece const& piece, int roundness) {
    std::vector<Point> points;
    switch (piece.form) {
    case ShapeForm::circle:
        points = roundOutline(0, piece.radius, roundness);
        break;
    case ShapeForm::capsule:
        points = roundOutline(halfSegment(piece), piece.radius, roundness);
        break;
    case ShapeForm::box: {
        double const x = 0.5 * piece.width;
        double const y = 0.5 * piece.height;
        points = {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
        break;
    }
    case ShapeForm::polygon:
        for (Vec2 const corner : piece.corners) {
            points.push_back(toPoint(corner));
        }
        break;
    }
    Pose const pose = poseIn(piece);
    for (Point& point : points) {
        point = toWorld(pose, point);
    }
    return points;
}

double distanceTo(ShapePiece const& piece, Point local) {
    Point const p = toLocal(poseIn(piece), local);
    switch (piece.form) {
    case ShapeForm::circle:
        return length(p) - piece.radius;
    case ShapeForm::capsule:
        return length({std::max(std::abs(p.x) - halfSegment(piece), 0.0), p.y}) - piece.radius;
    case ShapeForm::box: {
        Point const q{std::abs(p.x) - 0.5 * piece.width, std::abs(p.y) - 0.5 * piece.height};
        return length({std::max(q.x, 0.0), std::max(q.y, 0.0)}) + std::min(std::max(q.x, q.y), 0.0);
    }
    case ShapeForm::polygon:
        return polygonDistance(piece.corners, p);
    }
    return std::numeric_limits<double>::infinity();
}

double distanceTo(Shape const& shape, Point local) {
    double least = std::numeric_limits<double>::infinity();
    for (ShapePiece const& piece : shape.pieces) {
        least = std::min(least, distanceTo(piece, local));
    }
    return least;
}

Extent extentOf(ShapePiece const& piece, Pose const& body) {
    Pose const inBody = poseIn(piece);
    Pose const pose{toWorld(body, inBody.at), body.angle + inBody.angle};
    double const c = std::abs(std::cos(pose.angle));
    double const s = std::abs(std::sin(pose.angle));
    Point half;
    switch (piece.form) {
    case ShapeForm::circle:
        half = {piece.radius, piece.radius};
        break;
    case ShapeForm::capsule:
        half = {halfSegment(piece) * c + piece.radius, halfSegment(piece) * s + piece.radius};
        break;
    case ShapeForm::box:
        half = {0.5 * (piece.width * c + piece.height * s), 0.5 * (piece.width * s + piece.height * c)};
        break;
    case ShapeForm::polygon: {
        Extent around;
        for (Vec2 const corner : piece.corners) {
            around.add(toWorld(pose, toPoint(corner)));
        }
        return around;
    }
    }
    Extent around;
    around.add(pose.at - half);
    around.add(pose.at + half);
    return around;
}

Extent extentOf(Shape const& shape, Pose const& body) {
    Extent around;
    for (ShapePiece const& piece : shape.pieces) {
        around.add(extentOf(piece, body));
    }
    return around;
}

std::optional<std::array<Point, 2>> clipLine(std::span<Point const> convex, Point at, Point direction) {
    double from = -std::numeric_limits<double>::infinity();
    double to = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < convex.size(); ++i) {
        Point const a = convex[i];
        Point const edge = convex[(i + 1) % convex.size()] - a;
        double const speed = crossOf(edge, direction); // positive: the line enters here
        double const ahead = crossOf(edge, at - a);
        if (speed == 0) {
            if (ahead < 0) {
                return std::nullopt;
            }
            continue;
        }
        double const t = -ahead / speed;
        (speed > 0 ? from : to) = speed > 0 ? std::max(from, t) : std::min(to, t);
    }
    if (!(from < to) || !std::isfinite(from) || !std::isfinite(to)) {
        return std::nullopt;
    }
    return std::array{at + from * direction, at + to * direction};
}

std::vector<Point> clipHalf(std::span<Point const> convex, Point at, Point normal) {
    std::vector<Point> kept; // the algorithm of Sutherland and Hodgman, for one line
    for (std::size_t i = 0; i < convex.size(); ++i) {
        Point const a = convex[i];
        Point const b = convex[(i + 1) % convex.size()];
        double const sideA = dot(a - at, normal);
        double const sideB = dot(b - at, normal);
        if (sideA >= 0) {
            kept.push_back(a);
        }
        if ((sideA > 0 && sideB < 0) || (sideA < 0 && sideB > 0)) {
            kept.push_back(a + (sideA / (sideA - sideB)) * (b - a));
        }
    }
    return kept;
}

std::vector<Point> insetOutline(std::span<Point const> convex, double distance) {
    std::vector<Point> left(convex.begin(), convex.end());
    for (std::size_t i = 0; i < convex.size() && !left.empty(); ++i) {
        Point const edge = convex[(i + 1) % convex.size()] - convex[i];
        double const span = length(edge);
        if (span > 0) {
            Point const inwards{-edge.y / span, edge.x / span};
            left = clipHalf(left, convex[i] + distance * inwards, inwards);
        }
    }
    return left;
}

Point nearestOnEdge(Shape const& shape, Point target) {
    Point best;
    double least = std::numeric_limits<double>::infinity();
    for (ShapePiece const& piece : shape.pieces) {
        std::vector<Point> const outline = outlineOf(piece);
        for (std::size_t i = 0; i < outline.size(); ++i) {
            Point const a = outline[i];
            Point const edge = outline[(i + 1) % outline.size()] - a;
            double const t = std::clamp(dot(target - a, edge) / std::max(dot(edge, edge), 1e-300), 0.0, 1.0);
            Point const candidate = a + t * edge;
            if (length(target - candidate) < least) {
                least = length(target - candidate);
                best = candidate;
            }
        }
    }
    return best;
}

Point toLocal(Pose const& pose, Point world) {
    Point const d = world - pose.at;
    double const c = std::cos(pose.angle);
    double const s = std::sin(pose.angle);
    return {c * d.x + s * d.y, -s * d.x + c * d.y};
}

} // namespace trembler::render
