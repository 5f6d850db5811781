// Where the name of an area is written.
#pragma once

#include "game/ui/shared/layout.hpp"
#include "render/draw/camera.hpp"
#include "render/scene/facts/shape_geometry.hpp"

#include <span>

namespace trembler::ui {

/// The middle, in the world (m), of a name of `size` pixels near the upper or lower edge of `area`, outside
/// or inside of it: of the places inside the view that no card covers, the one where the name covers the
/// least of `objects` and is not far from the area, and of equal ones the first in a fixed order that begins
/// above the middle of the area. What holds the whole name, like a board or water behind it, counts less than
/// an edge, and a gap between two objects that the name would bridge counts as half covered. `area` is not
/// empty.
[[nodiscard]] render::Point areaNamePlace(render::Camera const& camera, render::Extent const& area,
                                          render::Point size, std::span<render::Extent const> objects,
                                          std::span<Placed const> cards = {});

} // namespace trembler::ui
