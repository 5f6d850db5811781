#include "game/ui/shared/commands/carry_out_keys.hpp"

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
        if (info.fixed) {
            return refused; // it leaves this page: later keys of this picture were meant for the page that is
                            // left
        }
    }
    return refused;
}

bool isHeld(render::InputEvents const& input, KeyBindings const& bindings, std::string_view id) {
    auto const modifiers = [&](bool wanted, unsigned bits) {
        return !wanted || (input.modifiers() & bits) != 0;
    };
    auto const keys = bindings.keysOf(id);
    return std::any_of(keys.begin(), keys.end(), [&](Chord const& chord) {
        return input.keyHeld(chord.key) && modifiers(chord.ctrl, KMOD_CTRL) &&
               modifiers(chord.shift, KMOD_SHIFT) && modifiers(chord.alt, KMOD_ALT);
    });
}

} // namespace trembler::ui
