// The handle beside the selected part by which the player turns it.
#pragma once

#include "game/ui/shared/catalog/part_catalog.hpp"
#include "game/ui/tools/placing_tool.hpp"

#include <functional>
#include <optional>

namespace trembler::ui {

/// Where the handle is.
struct TurnHandle {
    Vec2 at;             ///< m
    double angle = 0;    ///< of the way to it from the part's place, rad
    Placement placement; ///< of its part, as it is now or in the hand
};

/// The handle of the selected part; nothing while the session runs, while nothing is selected, or while the
/// part is carried. `pixel`: the size of a pixel at UI scale 1 in the world, m. `covered`: whether a card
/// lies over a place of the world; then the handle is on the part's lower side, if no card lies there.
[[nodiscard]] std::optional<TurnHandle> turnHandle(Session const& session, PlacingTool const& placing,
                                                   PartCatalog& catalog, double pixel,
                                                   std::function<bool(Vec2)> const& covered);

} // namespace trembler::ui
