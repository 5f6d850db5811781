#include "game/ui/play/commands/command_sections.hpp"
#include "game/ui/shared/words.hpp"
#include "render/window/gamepad.hpp"

namespace trembler::ui {
namespace {

using render::Icon;

void undo(PlayParts& parts) {
    parts.placing.cancel();
    if (parts.group.dragging()) {
        parts.group.cancel();
    }
    if (parts.session.undo()) {
        parts.newWorld();
    }
}

void redo(PlayParts& parts) {
    parts.placing.cancel();
    if (parts.group.dragging()) {
        parts.group.cancel();
    }
    if (parts.session.redo()) {
        parts.newWorld();
    }
}

void allBack(PlayParts& parts) {
    if (parts.placing.cancel()) {
        return; // first the part in the hand goes back to where it came from
    }
    if (!parts.allBack.ask()) {
        parts.context.toasts.add(words::allBackAgain, render::ToastKind::News, AskedTwice::patience);
        return;
    }
    parts.placing.reset();
    parts.group.reset();
    parts.session.putAllBack();
    parts.newWorld();
    parts.context.toasts.add(words::allBackDone);
}

constexpr Command<PlayParts> undoingTable[] = {
    {.info = {.id = "undo",
              .keys = {{withCtrl(SDLK_z)}},
              .pad = {render::padKey(SDL_CONTROLLER_BUTTON_LEFTSHOULDER)},
              .use = KeyUse::repeats,
              .icon = Icon::Undo,
              .group = CommandGroup::building,
              .name = "Undo",
              .tip = "Undo",
              .help = "undo, redo",
              .padPhase = PadPhase::building},
     .run = undo,
     .available = [](PlayParts const& parts) { return parts.session.canUndo() || parts.placing.carried(); },
     .whyNot = [](PlayParts const& parts) -> char const* {
         return parts.run.building() ? words::nothingToUndo : nullptr;
     }},
    {.info = {.id = "redo",
              .keys = {{withCtrlShift(SDLK_z), withCtrl(SDLK_y)}},
              .pad = {render::padKey(SDL_CONTROLLER_BUTTON_RIGHTSHOULDER)},
              .use = KeyUse::repeats,
              .icon = Icon::Redo,
              .group = CommandGroup::building,
              .name = "Redo",
              .tip = "Redo",
              .help = "undo, redo",
              .padPhase = PadPhase::building},
     .run = redo,
     .available = [](PlayParts const& parts) { return parts.session.canRedo(); },
     .whyNot = [](PlayParts const& parts) -> char const* {
         return parts.run.building() ? words::nothingToRedo : nullptr;
     }},
    {.info = {.id = "all-back",
              .keys = {{{SDLK_BACKSPACE}}},
              .icon = Icon::Remove,
              .group = CommandGroup::building,
              .name = "Put all back",
              .tip = "Put all parts back into the toolbox",
              .help = "put all parts back"},
     .run = allBack,
     .available =
         [](PlayParts const& parts) {
             return parts.run.building() && (parts.placing.carried() || !(parts.session.placed().empty() &&
                                                                          parts.session.wires().empty()));
         },
     .whyNot = [](PlayParts const& parts) -> char const* {
         return parts.run.building() ? words::allThere : nullptr;
     }},
};

} // namespace

std::span<Command<PlayParts> const> undoingCommands() {
    return undoingTable;
}

} // namespace trembler::ui
