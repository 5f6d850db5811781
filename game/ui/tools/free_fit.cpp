#include "game/ui/tools/free_fit.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace trembler::ui {
namespace {

using render::Extent;
using render::Point;

constexpr int placesAcross = 24;
constexpr int placesDown = 16;
constexpr double scaleStep = 1.04;

/// The extents in pixels, y down, from the upper left corner of the smallest rectangle around all of them.
std::vector<Rect> inPixels(std::span<Extent const> extents, Extent const& all, double scale) {
    std::vector<Rect> rects;
    for (Extent const& extent : extents) {
        rects.push_back({{(extent.lower.x - all.lower.x) * scale, (all.upper.y - extent.upper.y) * scale},
                         {(extent.upper.x - all.lower.x) * scale, (all.upper.y - extent.lower.y) * scale}});
    }
    return rects;
}

bool isClear(std::span<Rect const> rects, Point at, std::span<Rect const> obstacles) {
    return std::none_of(rects.begin(), rects.end(), [&](Rect const& rect) {
        Rect const there{rect.low + at, rect.high + at};
        return std::any_of(obstacles.begin(), obstacles.end(),
                           [&](Rect const& obstacle) { return there.overlaps(obstacle); });
    });
}

} // namespace

std::optional<render::Camera> freeFit(render::Size viewport, std::span<FitGroup const> groups, double margin,
                                      double least, double most) {
    Extent all;
    for (FitGroup const& group : groups) {
        for (Extent const& extent : group.extents) {
            all.add(extent);
        }
    }
    if (all.empty() || !(least > 0)) {
        return std::nullopt;
    }
    double const width = viewport.width - 2 * margin;
    double const height = viewport.height - 2 * margin;
    Point const size = 2 * all.half();
    double const whole = std::min(width / std::max(size.x, 1e-3), height / std::max(size.y, 1e-3));
    Point const middle{0.5 * viewport.width, 0.5 * viewport.height};
    for (double scale = std::min(whole, most); scale >= least; scale /= scaleStep) {
        std::vector<std::vector<Rect>> rects;
        for (FitGroup const& group : groups) {
            rects.push_back(inPixels(group.extents, all, scale));
        }
        auto const isFree = [&](Point at) {
            for (std::size_t i = 0; i < groups.size(); ++i) {
                if (!isClear(rects[i], at, groups[i].obstacles)) {
                    return false;
                }
            }
            return true;
        };
        double const spareX = width - size.x * scale;
        double const spareY = height - size.y * scale;
        std::optional<Point> best;
        double nearest = 0;
        for (int i = 0; i <= placesAcross; ++i) {
            for (int j = 0; j <= placesDown; ++j) {
                Point const at{margin + spareX * i / placesAcross, margin + spareY * j / placesDown};
                Point const centre = at + 0.5 * scale * size;
                double const off = render::length(centre - middle);
                if ((!best || off < nearest) && isFree(at)) {
                    best = at;
                    nearest = off;
                }
            }
        }
        if (best) {
            render::Camera camera;
            camera.viewport = viewport;
            camera.pixelsPerMetre = scale;
            camera.centre = {all.lower.x + (middle.x - best->x) / scale,
                             all.upper.y - (middle.y - best->y) / scale};
            return camera;
        }
    }
    return std::nullopt;
}

} // namespace trembler::ui
