// Typing with a gamepad on the screen's keyboard, as a player does: one button after the other.
#pragma once

#include "tests/game/ui/virtual_pad.hpp"

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace trembler::ui::test {

class PadTypist {
public:
    PadTypist(Player& player, VirtualPad const& pad) : player_(player), pad_(pad) {}

    ScreenKeyboard const& keyboard() { return player_.app().context().letters; }

    /// Moves to the key and presses it; false if the page has none such.
    bool pressKey(std::function<bool(LetterKey const&)> const& wanted) {
        auto const& keys = keyboard().keys();
        auto const found = std::find_if(keys.begin(), keys.end(), wanted);
        if (found == keys.end()) {
            return false;
        }
        auto const target = static_cast<std::size_t>(found - keys.begin());
        std::size_t const row = found->row;
        for (std::size_t i = 0; i < rowsOfKeys && keys[keyboard().chosen()].row != row; ++i) {
            pad_.press(player_, SDL_CONTROLLER_BUTTON_DPAD_DOWN);
        }
        for (int i = 0; i < 12 && keyboard().chosen() != target; ++i) {
            pad_.press(player_, SDL_CONTROLLER_BUTTON_DPAD_RIGHT);
        }
        EXPECT_EQ(keyboard().chosen(), target);
        pad_.press(player_, SDL_CONTROLLER_BUTTON_A);
        return true;
    }
    bool pressKey(KeyAct act) {
        return pressKey([act](LetterKey const& key) { return key.act == act; });
    }
    /// Characters of UTF-8, turning the pages of keys as needed.
    void type(std::vector<std::string> const& characters) {
        for (std::string const& character : characters) {
            auto const isIt = [&](LetterKey const& key) {
                return key.act == KeyAct::type && key.text == character;
            };
            if (character == " ") {
                pad_.press(player_, SDL_CONTROLLER_BUTTON_Y);
                continue;
            }
            bool typed = pressKey(isIt);
            if (!typed) {
                pad_.push(player_, SDL_CONTROLLER_AXIS_TRIGGERLEFT, 30000);
                typed = pressKey(isIt);
            }
            if (!typed) {
                pad_.push(player_, SDL_CONTROLLER_AXIS_TRIGGERRIGHT, 30000);
                typed = pressKey(isIt);
                if (!typed) { // the signs were shown; back to letters
                    pad_.push(player_, SDL_CONTROLLER_AXIS_TRIGGERRIGHT, 30000);
                    typed = pressKey(isIt);
                }
            }
            EXPECT_TRUE(typed) << character;
        }
    }
    void type(std::string const& ascii) {
        std::vector<std::string> characters;
        for (char const c : ascii) {
            characters.emplace_back(1, c);
        }
        type(characters);
    }

private:
    Player& player_;
    VirtualPad const& pad_;
};

} // namespace trembler::ui::test
