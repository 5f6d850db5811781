#include "game/ui/shared/commands/carry_out_keys.hpp"

#include "game/ui/shared/commands/menu_keys.hpp"

#include <algorithm>
#include <vector>

namespace trembler::ui {

std::optional<std::size_t> carryOutKeys(std::span<SDL_Event const> events, KeyBindings const& bindings,
                                        CommandSet& commands) {
    std::vector<std::size_t> done;
    std::optional<std::size_t> refused;
    for (SDL_Event const& event : events) {
        if (event.type != SDL_KEYDOWN) {
            continue;
        }
        auto const index = bindings.find(commands, event.key.keysym);
        if (!index || std::find(done.begin(), done.end(), *index) != done.end()) {
            continue;
        }
        CommandInfo const& info = commands.info(*index);
        if (event.key.repeat != 0 && info.use != KeyUse::repeats) {
            continue;
        }
        done.push_back(*index);
        if (!commands.available(*index)) {
            refused = index;
        }
        commands.run(*index);
        if (info.leads) {
            return refused; // it leaves this page: later keys of this picture were meant for the page that is
                            // left
        }
    }
    return refused;
}

bool passesWidgets(SDL_Event const& event, KeyBindings const& bindings, CommandSet const& commands,
                   std::span<SDL_Keycode const> leading) {
    auto const index =
        event.type == SDL_KEYDOWN ? bindings.find(commands, event.key.keysym) : std::optional<std::size_t>();
    if (!index) {
        return false;
    }
    CommandInfo const& info = commands.info(*index);
    if (info.leads) {
        return true;
    }
    SDL_Keycode const key = event.key.keysym.sym;
    auto const meaning = menuKeyOf(event.key.keysym, bindings);
    if (render::isPadKey(key)) {
        bool const turnsPages = meaning == MenuKey::pageNext || meaning == MenuKey::pageBefore;
        return (!meaning || turnsPages) &&
               std::find(leading.begin(), leading.end(), info.pad.key) != leading.end();
    }
    return !meaning && ((key >= SDLK_F1 && key <= SDLK_F12) || (event.key.keysym.mod & KMOD_CTRL) != 0);
}

bool isHeld(render::InputEvents const& input, Chord const& chord) {
    auto const modifiers = [&](bool wanted, unsigned bits) {
        return !wanted || (input.modifiers() & bits) != 0;
    };
    return input.keyHeld(chord.key) && modifiers(chord.ctrl, KMOD_CTRL) &&
           modifiers(chord.shift, KMOD_SHIFT) && modifiers(chord.alt, KMOD_ALT);
}

bool isHeld(render::InputEvents const& input, KeyBindings const& bindings, std::string_view id) {
    auto const keys = bindings.keysOf(id);
    return std::any_of(keys.begin(), keys.end(), [&](Chord const& chord) { return isHeld(input, chord); });
}

} // namespace trembler::ui
