// A level as a card: its picture, its title and its stars.
#pragma once

#include "game/ui/shared/ui_context.hpp"

namespace trembler::ui {

/// Size of a card, pixels at UI scale 1.
inline constexpr float levelCardWidth = 196; ///< at least
inline constexpr float levelCardHeight = 186;

struct LevelCardOptions {
    bool current = false;         ///< it is on the screen behind
    bool next = false;            ///< it is the one to play next
    float width = levelCardWidth; ///< pixels at UI scale 1
};

/// Draws the card at the cursor, as an item "level ID" of the layout and of the focus. Returns whether the
/// player chose it; a level that cannot be played is never chosen.
bool drawLevelCard(UiContext& context, CatalogEntry const& entry, LevelCardOptions const& options);

} // namespace trembler::ui
