// The lane of the other run above the timeline.
#pragma once

#include "game/ui/play/whatif/what_if.hpp"
#include "game/ui/shared/commands/command_buttons.hpp"

#include <optional>

namespace trembler::ui {

/// Its height above the timeline, pixels at UI scale 1.
inline constexpr float whatIfLane = 32;

/// Draws the card "what if lane": that the other run does not count, the moment, where it first differs and
/// where it meets goals. Returns the frame that the player points at. Between Gui::beginFrame and endFrame.
[[nodiscard]] std::optional<std::uint64_t> drawWhatIfLane(CommandButtons& buttons, Timeline const& timeline,
                                                          WhatIfView const& view);

} // namespace trembler::ui
