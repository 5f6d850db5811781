#include "game/ui/play/commands/command_sections.hpp"
#include "game/ui/play/timeline/probe_panel.hpp"
#include "game/ui/play/whatif/what_if_tool.hpp"
#include "game/ui/shared/texts.hpp"
#include "render/window/gamepad.hpp"

namespace trembler::ui {
namespace {

using render::Icon;

constexpr int manyFrames = 10; // by which Shift goes at a time

bool hasPast(PlayParts const& parts) {
    return inARun(parts) && parts.timeline.last() > 0 && !parts.timeline.beginningAgain();
}

void showTimeline(PlayParts& parts) {
    parts.timeline.setOpen(!parts.timeline.open());
}

template <int way>
void stepInPast(PlayParts& parts) {
    parts.lookAtPast();
    parts.timeline.stepBy(way * (parts.context.shiftHeld() ? manyFrames : 1));
}

template <bool forwards>
void toMark(PlayParts& parts) {
    parts.lookAtPast();
    parts.timeline.seekMark(forwards);
}

void watchPast(PlayParts& parts) {
    parts.lookAtPast();
    parts.timeline.playOrPause();
}

/// Only at a moment of the past is there something to compare with.
void whatIf(PlayParts& parts) {
    parts.whatIfTool->reset();
    if (parts.whatIf->active()) {
        parts.whatIf->end();
    } else if (parts.whatIf->begin()) {
        parts.timeline.probes().setChoosing(false);
    } else {
        parts.context.toasts.add(
            text("A script was changed while it ran, so the run cannot be repeated up to this moment."),
            render::ToastKind::News, 6);
    }
}

constexpr Command<PlayParts> timelineTable[] = {
    {.info = {.id = "timeline",
              .keys = {{{SDLK_k}}},
              .pad = {render::padRightStickUp},
              .icon = Icon::Timeline,
              .group = CommandGroup::running,
              .name = "Timeline",
              .tip = "Show the timeline: look again at any moment of the run",
              .help = "the timeline of the run",
              .padPhase = PadPhase::running},
     .run = showTimeline,
     .on = [](PlayParts const& parts) { return parts.timeline.open(); }},
    {.info = {.id = "frame-back",
              .keys = {{{SDLK_PAGEUP}}},
              .pad = {render::padRightStickLeft},
              .use = KeyUse::repeats,
              .icon = Icon::Reset,
              .group = CommandGroup::running,
              .name = "One frame back",
              .tip = "Look one frame back in the run, with Shift ten",
              .help = "look back and forth in the run (Shift: ten frames)",
              .padPhase = PadPhase::running},
     .run = stepInPast<-1>,
     .available = hasPast},
    {.info = {.id = "frame-on",
              .keys = {{{SDLK_PAGEDOWN}}},
              .pad = {render::padRightStickRight},
              .use = KeyUse::repeats,
              .icon = Icon::Step,
              .group = CommandGroup::running,
              .name = "One frame on",
              .tip = "Look one frame on, with Shift ten",
              .help = "look back and forth in the run (Shift: ten frames)",
              .padPhase = PadPhase::running},
     .run = stepInPast<1>,
     .available = [](PlayParts const& parts) { return hasPast(parts) && parts.timeline.looksBack(); }},
    {.info = {.id = "mark-back",
              .keys = {{withCtrl(SDLK_PAGEUP)}},
              .use = KeyUse::repeats,
              .group = CommandGroup::running,
              .name = "Mark before",
              .tip = "Look at the mark before this moment",
              .help = "to the mark before, to the next one"},
     .run = toMark<false>,
     .available = hasPast},
    {.info = {.id = "mark-on",
              .keys = {{withCtrl(SDLK_PAGEDOWN)}},
              .use = KeyUse::repeats,
              .group = CommandGroup::running,
              .name = "Next mark",
              .tip = "Look at the next mark",
              .help = "to the mark before, to the next one"},
     .run = toMark<true>,
     .available = hasPast},
    {.info = {.id = "past-start",
              .keys = {{withCtrl(SDLK_HOME)}},
              .group = CommandGroup::running,
              .name = "Beginning of the run",
              .tip = "Look at the beginning of the run",
              .help = "to the beginning, to the present"},
     .run =
         [](PlayParts& parts) {
             parts.lookAtPast();
             parts.timeline.seek(0);
         },
     .available = hasPast},
    {.info = {.id = "past-end",
              .keys = {{{SDLK_END}}},
              .group = CommandGroup::running,
              .name = "The present",
              .tip = "Back to the present",
              .help = "to the beginning, to the present"},
     .run = [](PlayParts& parts) { parts.timeline.seek(parts.timeline.last()); },
     .available = hasPast},
    {.info = {.id = "watch-past",
              .keys = {{{SDLK_o}}},
              .icon = Icon::Play,
              .group = CommandGroup::running,
              .name = "Watch the past",
              .tip = "Play what was recorded from here on",
              .help = "play what was recorded",
              .whenOn = {Icon::Pause, "Pause", "Pause"}},
     .run = watchPast,
     .available = hasPast,
     .on = [](PlayParts const& parts) { return parts.timeline.playing(); }},
    {.info = {.id = "probe",
              .keys = {{{SDLK_F4}}},
              .icon = Icon::Curve,
              .group = CommandGroup::running,
              .name = "Plot",
              .tip = "Plot numbers of an object over the timeline: speed, voltage, force, loudness",
              .help = "plot numbers over the timeline"},
     .run =
         [](PlayParts& parts) {
             ProbePanel& probes = parts.timeline.probes();
             parts.timeline.setOpen(true);
             probes.setChoosing(!probes.choosing());
             if (probes.choosing() && parts.components.open()) {
                 parts.components.toggle();
             }
             parts.modsPanel.setOpen(false);
         },
     .available = inARun,
     .on = [](PlayParts const& parts) { return parts.timeline.probes().choosing(); }},
    {.info = {.id = "loop-past",
              .keys = {{{SDLK_j}}},
              .icon = Icon::Repeat,
              .group = CommandGroup::running,
              .name = "Repeat a section",
              .tip =
                  "Repeat a section: press at its beginning and at its end, and once more for the whole run",
              .help = "repeat a section of the run"},
     .run =
         [](PlayParts& parts) {
             parts.lookAtPast();
             parts.timeline.markLoop();
         },
     .available = hasPast,
     .on = [](PlayParts const& parts) { return parts.timeline.loop().has_value(); }},
    {.info = {.id = "continue-here",
              .keys = {{{SDLK_u}}},
              .pad = {render::padRightStickDown},
              .icon = Icon::GoOn,
              .group = CommandGroup::running,
              .name = "Go on from here",
              .tip = "Let the world run on from this moment; what came after it is forgotten",
              .help = "run on from the moment that is shown",
              .padPhase = PadPhase::running},
     .run = [](PlayParts& parts) { parts.continueHere(); },
     .available = [](PlayParts const& parts) { return hasPast(parts) && parts.timeline.looksBack(); }},
    {.info = {.id = "what-if",
              .keys = {{{SDLK_z}}},
              .pad = {render::padKey(SDL_CONTROLLER_BUTTON_LEFTSHOULDER)},
              .icon = Icon::Hint,
              .group = CommandGroup::running,
              .name = "What if",
              .tip = "Change something at this moment, and see the other run beside the real one",
              .help = "what if something had been different at the moment that is shown",
              .whenOn = {Icon::Hint, "End the what-if", "Show the real run alone again"},
              .padPhase = PadPhase::past},
     .run = whatIf,
     .available =
         [](PlayParts const& parts) {
             return hasPast(parts) && (parts.timeline.looksBack() || parts.whatIf->active());
         },
     .on = [](PlayParts const& parts) { return parts.whatIf->active(); }},
    {.info = {.id = "what-if-card",
              .keys = {{{SDLK_F9}}},
              .pad = {render::padKey(SDL_CONTROLLER_BUTTON_RIGHTSHOULDER)},
              .group = CommandGroup::running,
              .name = "Keys to the card",
              .tip = "Let the keys of menus work on the card of the what-if; {} leads back",
              .tipKey = "back",
              .help = "change numbers and effects of a what-if by keys",
              .padPhase = PadPhase::past},
     .run = [](PlayParts& parts) { parts.whatIfTool->giveCardKeys(!parts.whatIfTool->cardHasKeys()); },
     .available = [](PlayParts const& parts) { return parts.whatIf->active(); },
     .on = [](PlayParts const& parts) { return parts.whatIfTool->cardHasKeys(); }},
};

} // namespace

std::span<Command<PlayParts> const> timelineCommands() {
    return timelineTable;
}

} // namespace trembler::ui
