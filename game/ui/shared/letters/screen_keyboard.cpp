#include "game/ui/shared/letters/screen_keyboard.hpp"

#include "game/ui/shared/commands/menu_keys.hpp"
#include "game/ui/shared/letters/field_in_use.hpp"
#include "game/ui/shared/letters/keyboard_drawing.hpp"
#include "game/ui/shared/texts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trembler::ui {
namespace {

using render::isPadKey;
using render::padKey;

constexpr double beforeFirstRepeat = 0.35; // s
constexpr double perFurtherRepeat = 0.09;  // s

/// Whether the event comes from a real keyboard or a mouse.
bool isOfHands(SDL_Event const& event) {
    return event.type == SDL_MOUSEBUTTONDOWN || event.type == SDL_MOUSEWHEEL ||
           (event.type == SDL_KEYDOWN && !isPadKey(event.key.keysym.sym));
}

} // namespace

void ScreenKeyboard::show() {
    open_ = true;
    direction_.reset();
    wanted_ = {};
    if (ImGuiInputTextState const* const field = fieldInUse()) {
        lines_ = hasLines(*field);
        wanted_.page = takesNumbers(*field) ? KeyPage::numbers : KeyPage::letters;
    }
    wanted_.newLine = lines_;
    wanted_.german = languageInUse() == "de";
    keys_ = letterKeys(wanted_);
    chosen_ = 0;
    aim_ = 0.5 * keys_.front().width;
    if (wanted_.page == KeyPage::letters) { // the middle of the keys, from which all are near
        move(0, 1);
        move(0, 1);
    }
}

void ScreenKeyboard::hide() {
    open_ = false;
    direction_.reset();
    typed_.letAllGo();
}

void ScreenKeyboard::turnTo(KeyPage page) {
    wanted_.page = page;
    LetterKey const before = keys_[chosen_];
    keys_ = letterKeys(wanted_);
    // The ring stays on its key, or where it is.
    auto const same = std::find_if(keys_.begin(), keys_.end(), [&](LetterKey const& key) {
        return before.act == KeyAct::type ? key.row == before.row && key.left + key.width > before.left
                                          : key.act == before.act;
    });
    chosen_ = same == keys_.end() ? keys_.size() - 1 : static_cast<std::size_t>(same - keys_.begin());
    aim_ = keys_[chosen_].left + 0.5 * keys_[chosen_].width;
}

void ScreenKeyboard::move(int x, int y) {
    chosen_ = keyBeside(keys_, chosen_, x, y, aim_);
}

void ScreenKeyboard::repeat(double seconds) {
    if (!direction_) {
        return;
    }
    auto const steps = [](double held) {
        return held < beforeFirstRepeat ? 0.0 : 1 + std::floor((held - beforeFirstRepeat) / perFurtherRepeat);
    };
    double const before = direction_->held;
    direction_->held += std::clamp(seconds, 0.0, 0.25);
    for (double step = steps(before); step < steps(direction_->held); ++step) {
        move(direction_->x, direction_->y);
    }
}

void ScreenKeyboard::act(LetterKey const& key, SDL_Keycode pad, render::InputEvents& input) {
    switch (key.act) {
    case KeyAct::type:
        typed_.type(key.text, input);
        if (wanted_.page == KeyPage::capitals) { // one capital, as nearly always
            turnTo(KeyPage::letters);
        }
        break;
    case KeyAct::shift:
        turnTo(wanted_.page == KeyPage::capitals ? KeyPage::letters : KeyPage::capitals);
        break;
    case KeyAct::signs: {
        bool const letters = wanted_.page == KeyPage::letters || wanted_.page == KeyPage::capitals;
        turnTo(letters ? KeyPage::signs : KeyPage::letters);
        break;
    }
    case KeyAct::blank:
        typed_.type(" ", input);
        break;
    case KeyAct::newLine:
        typed_.hold(SDLK_RETURN, pad, input);
        break;
    case KeyAct::left:
        typed_.hold(SDLK_LEFT, pad, input);
        break;
    case KeyAct::right:
        typed_.hold(SDLK_RIGHT, pad, input);
        break;
    case KeyAct::erase:
        typed_.hold(SDLK_BACKSPACE, pad, input);
        break;
    case KeyAct::cancel:
        if (!waited_) {
            typed_.hold(SDLK_ESCAPE, 0, input);
        }
        hide();
        break;
    case KeyAct::done:
        if (lines_) {
            leave_ = true;
        } else if (!waited_) { // a list continues with the typed text
            typed_.hold(SDLK_RETURN, 0, input);
        }
        hide();
        break;
    }
}

void ScreenKeyboard::press(SDL_Keycode pad, render::InputEvents& input) {
    auto const direction = [&](int x, int y) {
        move(x, y);
        direction_ = Direction{pad, x, y, 0};
    };
    switch (pad) {
    case padKey(SDL_CONTROLLER_BUTTON_DPAD_LEFT):
        return direction(-1, 0);
    case padKey(SDL_CONTROLLER_BUTTON_DPAD_RIGHT):
        return direction(1, 0);
    case padKey(SDL_CONTROLLER_BUTTON_DPAD_UP):
        return direction(0, -1);
    case padKey(SDL_CONTROLLER_BUTTON_DPAD_DOWN):
        return direction(0, 1);
    case padKey(SDL_CONTROLLER_BUTTON_A): {
        LetterKey const key = keys_[chosen_]; // a copy, as pages turn
        return act(key, pad, input);
    }
    case padKey(SDL_CONTROLLER_BUTTON_B):
        return act({.act = KeyAct::cancel, .text = {}}, pad, input);
    case padKey(SDL_CONTROLLER_BUTTON_X):
        return act({.act = KeyAct::erase, .text = {}}, pad, input);
    case padKey(SDL_CONTROLLER_BUTTON_Y):
        return act({.act = KeyAct::blank, .text = {}}, pad, input);
    case padKey(SDL_CONTROLLER_BUTTON_LEFTSHOULDER):
        return act({.act = KeyAct::left, .text = {}}, pad, input);
    case padKey(SDL_CONTROLLER_BUTTON_RIGHTSHOULDER):
        return act({.act = KeyAct::right, .text = {}}, pad, input);
    case render::padLeftTrigger:
        return act({.act = KeyAct::shift, .text = {}}, pad, input);
    case render::padRightTrigger:
        return act({.act = KeyAct::signs, .text = {}}, pad, input);
    case padKey(SDL_CONTROLLER_BUTTON_START):
        return act({.act = KeyAct::done, .text = {}}, pad, input);
    default:
        return;
    }
}

bool ScreenKeyboard::fieldHasKeys() const {
    return fieldInUse() != nullptr;
}

void ScreenKeyboard::takeInput(render::InputEvents& input, KeyBindings const& bindings, double seconds) {
    waited_ = std::exchange(waits_, false);
    typed_.beginPicture(input);
    bool hands = false;
    bool pad = false;
    bool asked = false;
    for (SDL_Event const& event : input.events()) {
        hands = hands || isOfHands(event);
        if (event.type == SDL_KEYDOWN && isPadKey(event.key.keysym.sym)) {
            pad = true;
            asked = asked || menuKeyOf(event.key.keysym, bindings) == MenuKey::type;
        }
    }
    byPad_ = !hands && (pad || byPad_);
    if (hands && open_) {
        hide();
    }
    // After the keyboard the player may use the gamepad again: then its button only opens this.
    bool const opens = !open_ && pad && byPad_ && fieldInUse() != nullptr && (!waited_ || asked);
    if (!open_ && !opens) {
        return;
    }
    repeat(seconds);
    for (SDL_Event const& event : input.takePadKeys()) {
        SDL_Keycode const key = letterButtonOf(event.key.keysym.sym, bindings);
        if (event.type == SDL_KEYDOWN) {
            if (open_) {
                press(key, input);
            }
            continue;
        }
        if (direction_ && direction_->pad == key) {
            direction_.reset();
        }
        typed_.release(key);
        input.typeForWidgets(event); // it may have gone down before this was open
    }
    typed_.letGo(input);
    if (opens) {
        show();
    }
}

void ScreenKeyboard::beginPicture() {
    if (std::exchange(leave_, false) && fieldInUse() != nullptr) {
        ImGui::ClearActiveID();
    }
}

void ScreenKeyboard::draw(Layout& layout, KeyBindings const& bindings) {
    ImGuiInputTextState const* const field = fieldInUse();
    unsigned const before = std::exchange(field_, field == nullptr ? 0 : field->ID);
    if (field == nullptr) {
        if (open_) {
            hide();
        }
        return;
    }
    if (!open_ && byPad_ && !waits_ && before != field_) {
        show();
    }
    if (!open_) {
        return;
    }
    ImWchar const* const text = field->TextW.Data;
    int const cursor = std::clamp(field->GetCursorPos(), 0, field->CurLenW);
    drawKeyboard(layout, {.keys = keys_,
                          .chosen = chosen_,
                          .page = wanted_.page,
                          .before = inOneLine(text, text + cursor),
                          .behind = inOneLine(text + cursor, text + field->CurLenW),
                          .legend = legendOf(bindings)});
}

} // namespace trembler::ui
