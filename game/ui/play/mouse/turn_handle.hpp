// The knob beside the selected part by which it is turned.
#pragma once

#include "game/ui/shared/part_catalog.hpp"
#include "game/ui/tools/placing_tool.hpp"

#include <optional>

namespace trembler::ui {

/// Where it stands.
struct TurnHandle {
    Vec2 at;             ///< m
    Placement placement; ///< of its part, as it is now or in the hand
};

/// Nothing while the session runs, while nothing is selected, or while the part is carried. `pixel`: m that a
/// pixel at UI scale 1 is.
[[nodiscard]] std::optional<TurnHandle> turnHandle(Session const& session, PlacingTool const& placing,
                                                   PartCatalog& catalog, double pixel);

} // namespace trembler::ui
