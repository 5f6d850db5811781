// The sizes of the cards around a picture of a level, for everything that is drawn beside them.
#pragma once

namespace trembler::ui {

/// Widths in pixels at UI scale 1; the other cards stay clear of these.
inline constexpr float goalCardWidth = 316;
inline constexpr float toolboxWidth = 236;
inline constexpr float largeToolboxWidth = 292; ///< at most, of a toolbox of many parts
inline constexpr float cardGap = 16;
inline constexpr float bottomRow = 74;    ///< height of the cards at the bottom
inline constexpr float cornerRow = 74;    ///< height of the buttons in the top right corner
inline constexpr float roomyWidth = 1200; ///< of a window in which wide cards stand beside the others

} // namespace trembler::ui
