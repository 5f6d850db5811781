#include "render/scene/facts/drawn_copies.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::render {
namespace {

constexpr int piecesOfCurve = 8; // between two stated points

double farthest(std::vector<Vec2> const& points) {
    double reach = 0;
    for (Vec2 const point : points) {
        reach = std::max(reach, std::hypot(point.x, point.y));
    }
    return reach;
}

// Between b and c (t from 0 to 1), by Barry and Goldman's pyramid.
Point onCurve(Point a, Point b, Point c, Point d, double t) {
    auto const knot = [](Point from, Point to) { return std::max(std::sqrt(length(to - from)), 1e-6); };
    double const t1 = knot(a, b);
    double const t2 = t1 + knot(b, c);
    double const t3 = t2 + knot(c, d);
    double const at = t1 + t * (t2 - t1);
    auto const between = [&](Point p, Point q, double from, double to) {
        double const share = (at - from) / (to - from);
        return (1 - share) * p + share * q;
    };
    Point const ab = between(a, b, 0, t1);
    Point const bc = between(b, c, t1, t2);
    Point const cd = between(c, d, t2, t3);
    return between(between(ab, bc, 0, t2), between(bc, cd, t1, t3), t1, t2);
}

} // namespace

Pose poseOfCopy(DrawnShape const& shape, std::int32_t copy) {
    bool const spread = shape.turn == 0 && shape.step == Vec2{};
    double const turn = copy * (spread ? 2 * pi / std::max(shape.repeat, 1) : shape.turn);
    Point const about{shape.about.x, shape.about.y};
    Point const stated{shape.at.x, shape.at.y};
    Point const turned = toWorld({about, turn}, stated - about);
    return {turned + copy * Point{shape.step.x, shape.step.y}, shape.angle + turn};
}

double reachOf(DrawnShape const& shape) {
    switch (shape.form) {
    case DrawnForm::box:
        return 0.5 * std::hypot(shape.width, shape.height);
    case DrawnForm::capsule:
        return 0.5 * shape.width;
    case DrawnForm::circle:
        return shape.radius;
    case DrawnForm::ring:
    case DrawnForm::arc:
        return shape.radius + 0.5 * shape.thickness;
    case DrawnForm::polygon:
        return farthest(shape.corners);
    case DrawnForm::line:
        return farthest(shape.points) + shape.thickness;
    }
    return 0;
}

Extent extentOf(DrawnShape const& shape, Pose const& pose) {
    Extent around;
    auto const add = [&](double x, double y) { around.add(toWorld(pose, {x, y})); };
    switch (shape.form) {
    case DrawnForm::box:
        for (double const x : {-0.5 * shape.width, 0.5 * shape.width}) {
            add(x, -0.5 * shape.height);
            add(x, 0.5 * shape.height);
        }
        return around;
    case DrawnForm::capsule: {
        double const along = std::max(0.0, 0.5 * shape.width - shape.radius);
        add(-along, 0);
        add(along, 0);
        return around.widened(shape.radius);
    }
    case DrawnForm::circle:
    case DrawnForm::ring:
        add(0, 0);
        return around.widened(reachOf(shape));
    case DrawnForm::polygon:
        for (Vec2 const corner : shape.corners) {
            add(corner.x, corner.y);
        }
        return around;
    case DrawnForm::line:
        for (Point const point : pathOf(shape)) {
            add(point.x, point.y);
        }
        return around.widened(0.5 * shape.thickness);
    case DrawnForm::arc: {
        // Its ends, and its points that are farthest to the right, top, left and bottom in the world.
        double const begin = pose.angle + 0.5 * (pi - shape.sweep);
        auto const addAt = [&](double angle) {
            around.add(pose.at + shape.radius * Point{std::cos(angle), std::sin(angle)});
        };
        addAt(begin);
        addAt(begin + shape.sweep);
        double const quarter = 0.5 * pi;
        for (double angle = std::ceil(begin / quarter) * quarter; angle < begin + shape.sweep;
             angle += quarter) {
            addAt(angle);
        }
        return around.widened(0.5 * shape.thickness);
    }
    }
    return around;
}

std::vector<Point> pathOf(DrawnShape const& line) {
    std::vector<Point> stated;
    for (Vec2 const point : line.points) {
        stated.push_back({point.x, point.y});
    }
    if (!line.curved || stated.size() < 3) {
        return stated;
    }
    std::vector<Point> path{stated.front()};
    for (std::size_t i = 0; i + 1 < stated.size(); ++i) {
        // The ends go on as they begin.
        Point const before = i > 0 ? stated[i - 1] : 2.0 * stated[0] - stated[1];
        Point const after = i + 2 < stated.size() ? stated[i + 2] : 2.0 * stated[i + 1] - stated[i];
        for (int piece = 1; piece <= piecesOfCurve; ++piece) {
            path.push_back(
                onCurve(before, stated[i], stated[i + 1], after, static_cast<double>(piece) / piecesOfCurve));
        }
    }
    return path;
}

} // namespace trembler::render
