// The timeline below the scene: a track to drag along, with marks where something notable happened.
#pragma once

#include "game/ui/play/timeline/timeline.hpp"
#include "game/ui/shared/commands/command_buttons.hpp"

namespace trembler::ui {

/// Height that it takes above the buttons at the bottom, pixels at UI scale 1.
inline constexpr float timelineRow = 50;

/// From the left and the right end of the card to its track, pixels at UI scale 1.
inline constexpr float trackFromLeft = 3 * 44;
inline constexpr float trackFromRight = 4 * 44 + 112;

/// The player's request to the timeline.
struct TimelineRequest {
    std::optional<std::uint64_t> frame; ///< to be shown; another one than is shown
    std::optional<insight::Mark> why;   ///< was clicked
};

/// Draws the card "timeline" and lets the mouse drag along the track. Between Gui::beginFrame and endFrame.
[[nodiscard]] TimelineRequest drawTimelineBar(CommandButtons& buttons, Timeline const& timeline);

/// A marked event in words: "Contact: switch, left contact".
[[nodiscard]] std::string wordsOf(insight::Mark const& mark);

} // namespace trembler::ui
