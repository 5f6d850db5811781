#include "game/ui/shared/letters/typed_keys.hpp"

#include <algorithm>
#include <utility>

namespace trembler::ui {
namespace {

SDL_Event keyEvent(SDL_Keycode key, bool down) {
    SDL_Event event{};
    event.type = down ? SDL_KEYDOWN : SDL_KEYUP;
    event.key.state = down ? SDL_PRESSED : SDL_RELEASED;
    event.key.keysym.sym = key;
    event.key.keysym.scancode = SDL_GetScancodeFromKey(key);
    return event;
}

} // namespace

void TypedKeys::beginPicture(render::InputEvents& input) {
    for (SDL_Keycode const key : std::exchange(due_, {})) {
        input.typeForWidgets(keyEvent(key, false));
    }
}

void TypedKeys::type(std::string const& text, render::InputEvents& input) {
    SDL_Event event{};
    event.type = SDL_TEXTINPUT;
    std::copy_n(text.begin(), std::min(text.size(), sizeof(event.text.text) - 1), event.text.text);
    input.typeForWidgets(event);
}

void TypedKeys::hold(SDL_Keycode key, SDL_Keycode pad, render::InputEvents& input) {
    bool const down =
        std::any_of(held_.begin(), held_.end(), [&](Held const& held) { return held.key == key; });
    if (!down) {
        input.typeForWidgets(keyEvent(key, true));
        held_.push_back({key, pad, true});
    }
}

void TypedKeys::letGo(render::InputEvents& input) {
    std::erase_if(held_, [&](Held& held) {
        bool const fresh = std::exchange(held.fresh, false);
        if (held.pad != 0) {
            return false;
        }
        if (fresh) {
            due_.push_back(held.key);
        } else {
            input.typeForWidgets(keyEvent(held.key, false));
        }
        return true;
    });
}

void TypedKeys::release(SDL_Keycode pad) {
    for (Held& held : held_) {
        held.pad = pad != 0 && held.pad == pad ? 0 : held.pad;
    }
}

void TypedKeys::letAllGo() {
    for (Held const& held : std::exchange(held_, {})) {
        due_.push_back(held.key);
    }
}

} // namespace trembler::ui
