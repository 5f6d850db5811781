// The handle beside the selected part by which the player turns it.
#pragma once

#include "game/ui/shared/catalog/part_catalog.hpp"
#include "game/ui/tools/placing_tool.hpp"

#include <optional>

namespace trembler::ui {

/// Where the handle is.
struct TurnHandle {
    Vec2 at;             ///< m
    Placement placement; ///< of its part, as it is now or in the hand
};

/// The handle of the selected part; nothing while the session runs, while nothing is selected, or while the
/// part is carried. `pixel`: the size of a pixel at UI scale 1 in the world, m.
[[nodiscard]] std::optional<TurnHandle> turnHandle(Session const& session, PlacingTool const& placing,
                                                   PartCatalog& catalog, double pixel);

} // namespace trembler::ui
