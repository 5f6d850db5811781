// Fits a scene into the part of a window that cards leave free, so that it is as large as possible.
#pragma once

#include "game/ui/shared/layout.hpp"
#include "render/draw/camera.hpp"
#include "render/scene/facts/shape_geometry.hpp"

#include <optional>
#include <span>

namespace trembler::ui {

/// Rectangles of the world, m, and what they may not lie under, pixels.
struct FitGroup {
    std::span<render::Extent const> extents;
    std::span<Rect const> obstacles;
};

/// A view in which no extent lies under an obstacle of its group, or nearer than `margin` pixels to the
/// window's edge, and which shows the extents at the largest scale at which that is possible, up to `most`
/// pixels per metre. Scales are tried in steps of 4 %, places on a grid of the window; so the result is close
/// to the largest, and the same for the same arguments. Nothing if it is not possible at `least` pixels per
/// metre.
[[nodiscard]] std::optional<render::Camera> freeFit(render::Size viewport, std::span<FitGroup const> groups,
                                                    double margin, double least, double most);

} // namespace trembler::ui
