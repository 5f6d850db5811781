#include "game/ui/play/commands/command_sections.hpp"
#include "render/window/gamepad.hpp"

namespace trembler::ui {
namespace {

using render::Icon;

constexpr Command<PlayParts> runTable[] = {
    {.info = {.id = "run",
              .keys = {{{SDLK_SPACE}}},
              .pad = {render::padKey(SDL_CONTROLLER_BUTTON_X)},
              .icon = Icon::Play,
              .group = CommandGroup::running,
              .name = "Run",
              .tip = "Let the world run",
              .help = "run and stop",
              .whenOn = {Icon::Stop, "Stop", "Stop and put everything back as it was placed"}},
     .run = [](PlayParts& parts) { parts.run.runOrStop(); },
     .on = inARun},
    {.info = {.id = "pause",
              .keys = {{{SDLK_p}}},
              .pad = {render::padKey(SDL_CONTROLLER_BUTTON_Y)},
              .icon = Icon::Pause,
              .group = CommandGroup::running,
              .name = "Pause",
              .tip = "Pause",
              .help = "pause",
              .whenOn = {Icon::Play, "Go on", "Go on"}},
     .run =
         [](PlayParts& parts) {
             if (parts.timeline.looksBack()) {
                 parts.timeline.playOrPause();
             } else {
                 parts.run.pauseOrGo();
             }
         },
     .available = inARun,
     .on = [](PlayParts const& parts) { return parts.run.paused() && !parts.timeline.playing(); }},
    {.info = {.id = "step",
              .keys = {{{SDLK_f}}},
              .use = KeyUse::repeats, // held: slow motion
              .icon = Icon::Step,
              .group = CommandGroup::running,
              .name = "One frame",
              .tip = "One frame, a sixtieth of a second",
              .help = "one frame"},
     .run =
         [](PlayParts& parts) {
             if (parts.timeline.looksBack()) {
                 parts.timeline.stepBy(1);
             } else {
                 parts.run.step();
             }
         }},
    {.info = {.id = "fast",
              .keys = {{{SDLK_TAB}}},
              .use = KeyUse::held,
              .icon = Icon::FastForward,
              .group = CommandGroup::running,
              .name = "Fast",
              .tip = "Four times as fast",
              .help = "hold: four times as fast"},
     .run = [](PlayParts& parts) { parts.run.speed().switchFast(); },
     .available = inARun},
    {.info = {.id = "slower",
              .keys = {{{SDLK_MINUS}, {SDLK_KP_MINUS}}},
              .pad = {render::padKey(SDL_CONTROLLER_BUTTON_LEFTSHOULDER)},
              .use = KeyUse::repeats,
              .icon = Icon::Slower,
              .group = CommandGroup::running,
              .name = "Slower",
              .tip = "Slower: down to a quarter of the real speed",
              .help = "slower, faster",
              .padPhase = PadPhase::running},
     .run = [](PlayParts& parts) { parts.run.speed().slower(); },
     .available = [](PlayParts const& parts) { return parts.run.speed().canSlow(); }},
    {.info = {.id = "faster",
              .keys = {{{SDLK_PLUS}, {SDLK_EQUALS}}},
              .pad = {render::padKey(SDL_CONTROLLER_BUTTON_RIGHTSHOULDER)},
              .use = KeyUse::repeats,
              .icon = Icon::FastForward,
              .group = CommandGroup::running,
              .name = "Faster",
              .tip = "Faster: up to eight times the real speed",
              .help = "slower, faster",
              .padPhase = PadPhase::running},
     .run = [](PlayParts& parts) { parts.run.speed().faster(); },
     .available = [](PlayParts const& parts) { return parts.run.speed().canHurry(); }},
    {.info = {.id = "normal-speed",
              .keys = {{{SDLK_0}, {SDLK_KP_0}}},
              .group = CommandGroup::running,
              .name = "Real speed",
              .tip = "As fast as in reality",
              .help = "as fast as in reality"},
     .run = [](PlayParts& parts) { parts.run.speed().setNormal(); }},
};

} // namespace

std::span<Command<PlayParts> const> runCommands() {
    return runTable;
}

} // namespace trembler::ui
