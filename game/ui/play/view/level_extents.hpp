// What a view of a whole level shows.
#pragma once

#include "game/ui/play/view/goal_areas.hpp"
#include "game/ui/shared/catalog/part_catalog.hpp"
#include "game/ui/shared/layout.hpp"
#include "puzzle/session/session.hpp"
#include "render/draw/camera.hpp"
#include "render/scene/facts/shape_geometry.hpp"

#include <vector>

namespace trembler::ui {

/// Rectangles of the world, m.
struct LevelExtents {
    std::vector<render::Extent> seen; ///< objects as they are, and goals: no card may cover them
    std::vector<render::Extent>
        around; ///< placed parts, and where the lesson has one placed, with the handle
    std::vector<render::Extent> places; ///< where parts may be placed: only needed while a part is held
};

/// Where the rectangle of the world is in the window.
[[nodiscard]] Rect onScreen(render::Camera const& camera, render::Extent const& extent);

/// render::sceneFocus() of the session's world within the level's bounds.
[[nodiscard]] render::Extent focusOf(Session const& session);

[[nodiscard]] LevelExtents levelExtents(Session const& session, GoalAreas const& goals, PartCatalog& catalog);

} // namespace trembler::ui
