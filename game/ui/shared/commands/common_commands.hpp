// Commands that several screens have; each screen's own table defines their action.
#pragma once

#include "game/ui/shared/commands/command.hpp"
#include "game/ui/shared/words.hpp"
#include "render/window/gamepad.hpp"

namespace trembler::ui::common {

inline constexpr CommandInfo fullscreen{.id = "fullscreen",
                                        .keys = {{{SDLK_F11}}},
                                        .group = CommandGroup::program,
                                        .name = "Full screen",
                                        .tip = "Switch full screen on or off",
                                        .help = "fill the whole screen"};

inline constexpr CommandInfo back{.id = "back",
                                  .keys = {{{SDLK_ESCAPE}}},
                                  .pad = {render::padKey(SDL_CONTROLLER_BUTTON_B)},
                                  .essential = true,
                                  .leads = true,
                                  .icon = render::Icon::Back,
                                  .group = CommandGroup::program,
                                  .name = words::back,
                                  .tip = "Let go, deselect, close what is open, or else open the menu",
                                  .help = "levels, menu"};

inline constexpr CommandInfo help{.id = "help",
                                  .keys = {{{SDLK_F1}}},
                                  .icon = render::Icon::Why,
                                  .group = CommandGroup::program,
                                  .name = "Keys",
                                  .tip = "Keys",
                                  .help = "this page"};

} // namespace trembler::ui::common
