// A walk through every screen of the program, for tests that look at all of them.
#pragma once

#include "tests/game/ui/player.hpp"

#include <functional>
#include <string>

namespace trembler::ui::test {

/// Called at each screen with its name, which is the same in every walk and may be a file's.
using Look = std::function<void(std::string const& screen)>;

// Each part of the walk begins wherever the player is and visits its screens in a fixed order, always in the
// same state. The player should have set less motion: otherwise pictures depend on moving objects.

/// Title and pages of the menu.
void walkMenus(Player& player, Look const& look);
/// A level from its start to its end, with everything that may lie beside it.
void walkLevel(Player& player, Look const& look);
/// Demonstrations, overlays, panels, mods, free play.
void walkOthers(Player& player, Look const& look);
/// The editor: every page of its panel, its dialogs, and a test.
void walkEditor(Player& player, Look const& look);
/// The same without the pages of walkStudies.
void walkEditorWithoutStudies(Player& player, Look const& look);
/// The editor's report on a level, and its search for solutions, which take longer than all other screens
/// together.
void walkStudies(Player& player, Look const& look);

/// All of it.
inline void walkScreens(Player& player, Look const& look) {
    walkMenus(player, look);
    walkLevel(player, look);
    walkOthers(player, look);
    walkEditor(player, look);
}

} // namespace trembler::ui::test
