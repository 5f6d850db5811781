#include "render/draw/path.hpp"

#include <algorithm>

namespace trembler::render {

std::vector<Point> bezier(Point from, Point fromHandle, Point toHandle, Point to, int pieces) {
    int const count = std::max(pieces, 1);
    std::vector<Point> path;
    path.reserve(static_cast<std::size_t>(count) + 1);
    for (int i = 0; i <= count; ++i) {
        double const t = static_cast<double>(i) / count;
        double const u = 1 - t;
        path.push_back(u * u * u * from + 3 * u * u * t * fromHandle + 3 * u * t * t * toHandle +
                       t * t * t * to);
    }
    return path;
}

std::vector<Point> hangingWire(Point from, Point to, double sag, int pieces) {
    // A parabola is the Bézier curve of degree two whose handle lies twice as deep as its lowest point.
    Point const low = 0.5 * (from + to) - Point{0, 2 * sag};
    return bezier(from, (1.0 / 3) * from + (2.0 / 3) * low, (1.0 / 3) * to + (2.0 / 3) * low, to, pieces);
}

std::vector<Point> coil(Point from, Point to, double halfWidth, int turns) {
    Point const along = to - from;
    double const span = length(along);
    if (span <= 0 || turns < 1) {
        return {from, to};
    }
    Point const across{-along.y / span, along.x / span};
    std::vector<Point> path{from, from + 0.1 * along};
    int const peaks = 2 * turns;
    for (int i = 0; i < peaks; ++i) {
        double const t = 0.1 + 0.8 * (i + 0.5) / peaks;
        path.push_back(from + t * along + (i % 2 == 0 ? halfWidth : -halfWidth) * across);
    }
    path.push_back(from + 0.9 * along);
    path.push_back(to);
    return path;
}

double pathLength(std::span<Point const> path) {
    double sum = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
        sum += length(path[i] - path[i - 1]);
    }
    return sum;
}

Point pointAlong(std::span<Point const> path, double distance) {
    if (path.empty()) {
        return {};
    }
    double left = std::max(distance, 0.0);
    for (std::size_t i = 1; i < path.size(); ++i) {
        double const piece = length(path[i] - path[i - 1]);
        if (left <= piece && piece > 0) {
            return path[i - 1] + (left / piece) * (path[i] - path[i - 1]);
        }
        left -= piece;
    }
    return path.back();
}

} // namespace trembler::render
