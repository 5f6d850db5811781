// The sizes of the cards around a picture of a level, for everything that is drawn beside them.
#pragma once

#include <algorithm>

namespace trembler::ui {

/// Widths in pixels at UI scale 1; the other cards stay clear of these.
inline constexpr float goalCardWidth = 316;     ///< of a column beside a picture, and of the card of hints
inline constexpr float inspectorWidth = 324;    ///< and that of the card that says why
inline constexpr float smallToolboxWidth = 236; ///< at most
inline constexpr float largeToolboxWidth = 292; ///< at most, of a toolbox of many parts
inline constexpr float cardGap = 16;
inline constexpr float bottomRow = 74;    ///< height of the cards at the bottom
inline constexpr float cornerRow = 74;    ///< height of the buttons in the top right corner
inline constexpr float cornerWidth = 372; ///< width of those buttons, when there are most of them
inline constexpr float roomyWidth = 1200; ///< of a window in which wide cards stand beside the others

/// Where a card stands that is as high as its content, pixels at UI scale 1.
struct SidePlace {
    float right = cardGap; ///< from the right edge of the window
    float top = cornerRow;
    float height = 0; ///< the most that it may have
};

/// The least share of the window's width that the cards around a level leave to the scene.
inline constexpr float stageShare = 0.7F;

/// The width of the toolbox in a window of this width; `large`: it has many parts. Beside it there is always
/// room for the scene.
[[nodiscard]] constexpr float toolboxWidth(float window, bool large) {
    return std::min(large ? largeToolboxWidth : smallToolboxWidth, (1 - stageShare) * window - 2 * cardGap);
}

/// The width of the goals, which lie above the scene, beside the buttons in the corner. `taken`: what else
/// stands beside those buttons.
[[nodiscard]] constexpr float goalStripWidth(float window, float taken = 0) {
    return std::min(window - cornerWidth - 3 * cardGap - taken, 900.F);
}

} // namespace trembler::ui
