#include "render/scene/marks/dashes.hpp"

#include "render/draw/path.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace trembler::render {
namespace {

constexpr double mostDashes = 600;

// The part of a path between two lengths along it.
std::vector<Point> section(std::span<Point const> path, double from, double to) {
    std::vector<Point> part{pointAlong(path, from)};
    double at = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
        at += length(path[i] - path[i - 1]);
        if (at > from && at < to) {
            part.push_back(path[i]);
        }
    }
    part.push_back(pointAlong(path, to));
    return part;
}

} // namespace

void dashed(Canvas& canvas, std::span<Point const> path, bool closed, double dash, double gap,
            Stroke const& stroke) {
    std::vector<Point> all(path.begin(), path.end());
    if (closed && !all.empty()) {
        all.push_back(all.front());
    }
    double const total = all.size() >= 2 ? pathLength(all) : 0;
    if (!(total > 0) || !std::isfinite(total) || !(dash > 0) || !(gap > 0)) {
        return;
    }
    double const requested = std::clamp(std::round(total / (dash + gap)), 1.0, mostDashes);
    double const period = closed || requested == mostDashes ? total / requested : dash + gap;
    double const part = dash / (dash + gap) * period;
    auto const count = static_cast<int>(std::ceil(total / period - 1e-9));
    for (int i = 0; i < count; ++i) {
        canvas.polyline(section(all, i * period, std::min(i * period + part, total)), stroke);
    }
}

} // namespace trembler::render
