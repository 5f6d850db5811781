// A screen with a few commands that count how often they run.
#pragma once

#include "game/ui/shared/commands/key_bindings.hpp"

#include <SDL_events.h>

#include <array>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace trembler::ui::test {

struct Counting {
    std::map<std::string, int> done;
    bool mayJump = true;
};

template <char which>
void count(Counting& counting) {
    ++counting.done[std::string(1, which)];
}

inline constexpr std::array countingTable{
    Command<Counting>{
        .info = {.id = "walk", .keys = {{{SDLK_w}, {SDLK_UP}}}, .name = "Walk", .tip = "Walk", .help = "go"},
        .run = count<'w'>},
    Command<Counting>{.info = {.id = "run",
                               .keys = {{{.key = SDLK_w, .shift = true}}},
                               .name = "Run",
                               .tip = "Run",
                               .help = "go"},
                      .run = count<'r'>},
    Command<Counting>{.info = {.id = "jump",
                               .keys = {{withCtrl(SDLK_j)}},
                               .use = KeyUse::repeats,
                               .name = "Jump",
                               .tip = "Jump",
                               .help = "jump"},
                      .run = count<'j'>,
                      .available = [](Counting const& counting) { return counting.mayJump; }},
    Command<Counting>{.info = {.id = "crouch",
                               .keys = {{{SDLK_c}}},
                               .use = KeyUse::held,
                               .name = "Crouch",
                               .tip = "Crouch",
                               .help = "crouch"},
                      .run = count<'c'>},
    Command<Counting>{.info = {.id = "leave",
                               .keys = {{{SDLK_ESCAPE}}},
                               .essential = true,
                               .leads = true,
                               .name = "Leave",
                               .tip = "Leave",
                               .help = "leave"},
                      .run = count<'l'>},
    Command<Counting>{
        .info = {.id = "door", .name = "Door", .tip = "Door", .help = "door", .alsoBy = "leave"},
        .run = count<'d'>},
};

/// Another screen, which shares "walk" and uses a key of the first screen for another command.
inline constexpr std::array otherTable{
    Command<Counting>{.info = countingTable[0].info, .run = count<'w'>},
    Command<Counting>{
        .info = {.id = "paint", .keys = {{{SDLK_c}}}, .name = "Paint", .tip = "Paint", .help = "paint"},
        .run = count<'p'>},
};

inline std::vector<CommandList> countingLists() {
    return {listOf(std::span<Command<Counting> const>(countingTable)),
            listOf(std::span<Command<Counting> const>(otherTable))};
}

inline CommandInfo const& infoOf(KeyBindings const& bindings, std::string_view id) {
    for (CommandInfo const* command : bindings.commands()) {
        if (command->id == id) {
            return *command;
        }
    }
    throw std::invalid_argument(std::string(id));
}

inline SDL_Event keyDown(SDL_Keycode key, int modifiers = KMOD_NONE, bool repeat = false) {
    SDL_Event event{};
    event.type = SDL_KEYDOWN;
    event.key.keysym.sym = key;
    event.key.keysym.mod = static_cast<std::uint16_t>(modifiers);
    event.key.repeat = repeat ? 1 : 0;
    return event;
}

} // namespace trembler::ui::test
