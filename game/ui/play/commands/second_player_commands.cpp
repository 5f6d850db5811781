#include "game/ui/play/commands/command_sections.hpp"
#include "game/ui/play/mouse/second_player.hpp"
#include "render/window/pad_keys.hpp"

namespace trembler::ui {
namespace {

constexpr CommandInfo secondPlayerCommand(std::string_view id, SDL_GameControllerButton button, Phrase name,
                                          Phrase tip, Phrase help) {
    return {.id = id,
            .pad = {render::padKey(button)},
            .use = KeyUse::held,
            .group = CommandGroup::secondPlayer,
            .name = name,
            .tip = tip,
            .help = help,
            .padPhase = PadPhase::secondPlayer};
}

/// The second player's pointer reads them, see secondPlayerNow().
void nothingAtOnce(PlayParts& /*parts*/) {}

constexpr Command<PlayParts> secondPlayerTable[] = {
    {.info = secondPlayerCommand(second_player::left, SDL_CONTROLLER_BUTTON_DPAD_LEFT,
                                 "Second player: to the left", "Move the second player's pointer to the left",
                                 "move the second player's pointer"),
     .run = nothingAtOnce},
    {.info = secondPlayerCommand(
         second_player::right, SDL_CONTROLLER_BUTTON_DPAD_RIGHT, "Second player: to the right",
         "Move the second player's pointer to the right", "move the second player's pointer"),
     .run = nothingAtOnce},
    {.info = secondPlayerCommand(second_player::up, SDL_CONTROLLER_BUTTON_DPAD_UP, "Second player: up",
                                 "Move the second player's pointer up", "move the second player's pointer"),
     .run = nothingAtOnce},
    {.info = secondPlayerCommand(second_player::down, SDL_CONTROLLER_BUTTON_DPAD_DOWN, "Second player: down",
                                 "Move the second player's pointer down", "move the second player's pointer"),
     .run = nothingAtOnce},
    {.info = secondPlayerCommand(second_player::grab, SDL_CONTROLLER_BUTTON_A, "Second player: take hold",
                                 "The second player holds what their pointer is at",
                                 "the second player takes hold"),
     .run = nothingAtOnce},
};

} // namespace

std::span<Command<PlayParts> const> secondPlayerCommands() {
    return secondPlayerTable;
}

} // namespace trembler::ui
