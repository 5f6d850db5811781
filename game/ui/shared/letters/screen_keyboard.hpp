// A keyboard on the screen, by which a gamepad types into any field for text or numbers.
#pragma once

#include "game/ui/shared/commands/key_bindings.hpp"
#include "game/ui/shared/layout.hpp"
#include "game/ui/shared/letters/letter_keys.hpp"
#include "game/ui/shared/letters/typed_keys.hpp"
#include "render/window/input_events.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace trembler::ui {

/// Opens when a field gets the keys by a gamepad, and closes when it loses them, or when a real key or the
/// mouse is used. While it is open the gamepads' buttons act on it alone: the directional pad moves, A
/// presses a key, X deletes, Y is a blank, L1 and R1 move the cursor, L2 and R2 turn to capitals and signs,
/// Start ends the typing, B gives it up. The typed text reaches the field as if it came from a real keyboard,
/// and nothing else. Window thread only.
class ScreenKeyboard {
public:
    /// Between InputEvents::poll and Gui::beginFrame.
    void takeInput(render::InputEvents& input, KeyBindings const& bindings, double seconds);
    /// Whether a text field has the keyboard, also before Gui::beginFrame.
    [[nodiscard]] bool fieldHasKeys() const;
    /// After Gui::beginFrame, before any widget.
    void beginPicture();
    /// After all widgets of the picture: opens or closes it, and draws it.
    void draw(Layout& layout, KeyBindings const& bindings);

    /// For a list in which a gamepad moves while the field above it has the keys, in this picture: it opens
    /// only if asked for, by the button that begins to type.
    void waitToBeAsked() { waits_ = true; }
    [[nodiscard]] bool open() const { return open_; }
    /// Whether the next picture may be another one even if nothing happens.
    [[nodiscard]] bool busy() const { return direction_.has_value() || typed_.any(); }

    /// The keys that it shows, and the index of the one that A presses.
    [[nodiscard]] std::vector<LetterKey> const& keys() const { return keys_; }
    [[nodiscard]] std::size_t chosen() const { return chosen_; }

private:
    /// A direction that is held, for how long.
    struct Direction {
        SDL_Keycode pad;
        int x;
        int y;
        double held; ///< s
    };
    void show();
    void hide();
    /// Carries out the action of one button that went down.
    void press(SDL_Keycode pad, render::InputEvents& input);
    void act(LetterKey const& key, SDL_Keycode pad, render::InputEvents& input);
    void turnTo(KeyPage page);
    void move(int x, int y);
    void repeat(double seconds);

    bool open_ = false;
    bool byPad_ = false;  // the device used last
    bool waits_ = false;  // of this picture
    bool waited_ = false; // of the last one
    bool leave_ = false;  // the field of several lines, which Enter does not end
    bool lines_ = false;  // the field has several
    unsigned field_ = 0;  // that had the keys in the last picture, by ImGui's number; 0: none
    KeysWanted wanted_;
    std::vector<LetterKey> keys_;
    std::size_t chosen_ = 0;
    double aim_ = 0;
    std::optional<Direction> direction_;
    TypedKeys typed_;
};

} // namespace trembler::ui
