// The look of the keyboard on the screen.
#pragma once

#include "game/ui/shared/commands/key_bindings.hpp"
#include "game/ui/shared/layout.hpp"
#include "game/ui/shared/letters/letter_keys.hpp"

#include <span>
#include <string>

namespace trembler::ui {

struct ShownKeyboard {
    std::span<LetterKey const> keys;
    std::size_t chosen = 0;
    KeyPage page = KeyPage::letters;
    std::string before; ///< the typed text in front of the cursor; UTF-8, one line
    std::string behind;
    std::string legend; ///< what the buttons do
};

/// The buttons of a gamepad and what they do while the keyboard is open, in the player's language.
[[nodiscard]] std::string legendOf(KeyBindings const& bindings);

/// A card at the bottom of the window, over all others, with the typed text above the keys, as the field may
/// be beneath it. Between Gui::beginFrame and endFrame.
void drawKeyboard(Layout& layout, ShownKeyboard const& shown);

} // namespace trembler::ui
