// The bars around the edited scene: menus, tools, and the line with the grid and the mouse's place.
#pragma once

#include "game/ui/edit/edit_parts.hpp"

#include <optional>

namespace trembler::ui {

// Room that they take, pixels at UI scale 1.
inline constexpr float topBar = 62;
inline constexpr float toolColumn = 60;
inline constexpr float statusRow = 62;
inline constexpr float statusWidth = 500; ///< at most
inline constexpr float sidePanelWidth = 300;
inline constexpr float editGap = 10;

/// Draws them; returns the command that was asked for. Between Gui::beginFrame and endFrame.
[[nodiscard]] std::optional<std::size_t> drawBars(EditParts& parts, CommandSet const& commands);

} // namespace trembler::ui
