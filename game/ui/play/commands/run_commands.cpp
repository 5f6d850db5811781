#include "game/ui/play/commands/command_sections.hpp"

namespace trembler::ui {
namespace {

using render::Icon;

constexpr Command<PlayParts> runTable[] = {
    {.info = {.id = "run",
              .keys = {{{SDLK_SPACE}}},
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
              .icon = Icon::Pause,
              .group = CommandGroup::running,
              .name = "Pause",
              .tip = "Pause",
              .help = "pause",
              .whenOn = {Icon::Play, "Go on", "Go on"}},
     .run = [](PlayParts& parts) { parts.run.pauseOrGo(); },
     .available = inARun,
     .on = [](PlayParts const& parts) { return parts.run.paused(); }},
    {.info = {.id = "step",
              .keys = {{{SDLK_f}}},
              .use = KeyUse::repeats, // held: slow motion
              .icon = Icon::Step,
              .group = CommandGroup::running,
              .name = "One frame",
              .tip = "One frame, a sixtieth of a second",
              .help = "one frame"},
     .run = [](PlayParts& parts) { parts.run.step(); }},
    {.info = {.id = "fast",
              .keys = {{{SDLK_TAB}}},
              .use = KeyUse::held,
              .icon = Icon::FastForward,
              .group = CommandGroup::running,
              .name = "Fast",
              .tip = "Four times as fast",
              .help = "hold: four times as fast"},
     .run = [](PlayParts& parts) { parts.run.switchFast(); },
     .available = inARun,
     .on = [](PlayParts const& parts) { return parts.run.fast(); }},
};

} // namespace

std::span<Command<PlayParts> const> runCommands() {
    return runTable;
}

} // namespace trembler::ui
