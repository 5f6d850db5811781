#include "game/ui/play/commands/command_sections.hpp"
#include "game/ui/shared/words.hpp"
#include "render/window/gamepad.hpp"

namespace trembler::ui {
namespace {

using render::Icon;

/// Whether a part is in the hand or selected, so that keys can turn it, move it and put it back.
bool partAtHand(PlayParts const& parts) {
    return parts.run.building() && (parts.placing.carried() || parts.placing.selected() || parts.group.any());
}
/// Whether commands act on the chosen parts together.
bool actsOnGroup(PlayParts const& parts) {
    return parts.group.any() && !parts.placing.carried();
}

/// Calls doing(tool) with the tool of several parts, or with that of one, which may give the session another
/// world.
template <class Doing>
void place(PlayParts& parts, Doing&& doing) {
    World const* const world = &parts.session.world();
    if (actsOnGroup(parts)) {
        doing(parts.group);
    } else {
        doing(parts.placing);
    }
    if (world != &parts.session.world()) {
        parts.newWorld();
    }
}

template <int steps>
void turn(PlayParts& parts) {
    place(parts, [&](auto& tool) { tool.turn(steps, parts.context.shiftHeld()); });
}

template <int x, int y>
void nudge(PlayParts& parts) {
    place(parts, [&](auto& tool) { tool.nudge({x, y}, parts.context.shiftHeld()); });
}

void undo(PlayParts& parts) {
    parts.placing.cancel();
    parts.group.cancel();
    parts.wires.cancel();
    if (parts.session.undo()) {
        parts.newWorld();
    }
}

void redo(PlayParts& parts) {
    parts.placing.cancel();
    parts.group.cancel();
    parts.wires.cancel();
    if (parts.session.redo()) {
        parts.newWorld();
    }
}

void allBack(PlayParts& parts) {
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

void duplicate(PlayParts& parts) {
    World const* const world = &parts.session.world();
    parts.group.duplicate();
    if (world != &parts.session.world()) {
        parts.newWorld();
    }
}

constexpr Command<PlayParts> buildingTable[] = {
    {.info = {.id = "turn-left",
              .keys = {{{SDLK_q}}},
              .use = KeyUse::repeats,
              .icon = Icon::TurnLeft,
              .group = CommandGroup::building,
              .name = "Turn left",
              .tip = "Turn the part in hand to the left by 15°, with Shift by 1°",
              .help = "turn the part in hand (Shift: 1°)"},
     .run = turn<1>,
     .available = partAtHand},
    {.info = {.id = "turn-right",
              .keys = {{{SDLK_e}}},
              .use = KeyUse::repeats,
              .icon = Icon::TurnRight,
              .group = CommandGroup::building,
              .name = "Turn right",
              .tip = "Turn the part in hand to the right by 15°, with Shift by 1°",
              .help = "turn the part in hand (Shift: 1°)"},
     .run = turn<-1>,
     .available = partAtHand},
    {.info = {.id = "move-left",
              .keys = {{{SDLK_LEFT}}},
              .use = KeyUse::repeats,
              .group = CommandGroup::building,
              .name = "Move left",
              .tip = "Move the selected part to the left, with Shift by less",
              .help = "move the selected part (Shift: finer)"},
     .run = nudge<-1, 0>,
     .available = partAtHand},
    {.info = {.id = "move-right",
              .keys = {{{SDLK_RIGHT}}},
              .use = KeyUse::repeats,
              .group = CommandGroup::building,
              .name = "Move right",
              .tip = "Move the selected part to the right, with Shift by less",
              .help = "move the selected part (Shift: finer)"},
     .run = nudge<1, 0>,
     .available = partAtHand},
    {.info = {.id = "move-up",
              .keys = {{{SDLK_UP}}},
              .use = KeyUse::repeats,
              .group = CommandGroup::building,
              .name = "Move up",
              .tip = "Move the selected part up, with Shift by less",
              .help = "move the selected part (Shift: finer)"},
     .run = nudge<0, 1>,
     .available = partAtHand},
    {.info = {.id = "move-down",
              .keys = {{{SDLK_DOWN}}},
              .use = KeyUse::repeats,
              .group = CommandGroup::building,
              .name = "Move down",
              .tip = "Move the selected part down, with Shift by less",
              .help = "move the selected part (Shift: finer)"},
     .run = nudge<0, -1>,
     .available = partAtHand},
    {.info = {.id = "put-back",
              .keys = {{{SDLK_DELETE}}},
              .icon = Icon::Remove,
              .group = CommandGroup::building,
              .name = "Put back",
              .tip = "Put the part in hand back into the toolbox",
              .help = "put the part back"},
     .run = [](PlayParts& parts) { place(parts, [](auto& tool) { tool.putBack(); }); },
     .available = partAtHand},
    {.info = {.id = "choose-all",
              .keys = {{withCtrl(SDLK_a)}},
              .group = CommandGroup::building,
              .name = "Choose all",
              .tip = "Choose all placed parts, to move, turn or put them back together",
              .help = "choose all parts"},
     .run = [](PlayParts& parts) { parts.group.chooseAll(); },
     .available =
         [](PlayParts const& parts) { return parts.run.building() && !parts.session.placed().empty(); }},
    {.info = {.id = "duplicate",
              .keys = {{withCtrl(SDLK_d)}},
              .group = CommandGroup::building,
              .name = "Duplicate",
              .tip = "Place another one of each chosen part, as far as the toolbox has them",
              .help = "place the same parts again"},
     .run = duplicate,
     .available = [](PlayParts const& parts) { return partAtHand(parts) && !parts.placing.carried(); }},
    {.info = {.id = "undo",
              .keys = {{withCtrl(SDLK_z)}},
              .pad = {render::padKey(SDL_CONTROLLER_BUTTON_LEFTSHOULDER)},
              .use = KeyUse::repeats,
              .icon = Icon::Undo,
              .group = CommandGroup::building,
              .name = "Undo",
              .tip = "Undo",
              .help = "undo, redo"},
     .run = undo,
     .available = [](PlayParts const& parts) { return parts.session.canUndo() || parts.placing.carried(); }},
    {.info = {.id = "redo",
              .keys = {{withCtrlShift(SDLK_z), withCtrl(SDLK_y)}},
              .pad = {render::padKey(SDL_CONTROLLER_BUTTON_RIGHTSHOULDER)},
              .use = KeyUse::repeats,
              .icon = Icon::Redo,
              .group = CommandGroup::building,
              .name = "Redo",
              .tip = "Redo",
              .help = "undo, redo"},
     .run = redo,
     .available = [](PlayParts const& parts) { return parts.session.canRedo(); }},
    {.info = {.id = "all-back",
              .keys = {{{SDLK_BACKSPACE}}},
              .icon = Icon::Reset,
              .group = CommandGroup::building,
              .name = "Put all back",
              .tip = "Put all parts back into the toolbox",
              .help = "put all parts back"},
     .run = allBack,
     .available =
         [](PlayParts const& parts) {
             return parts.run.building() &&
                    !(parts.session.placed().empty() && parts.session.wires().empty());
         }},
};

} // namespace

std::span<Command<PlayParts> const> buildingCommands() {
    return buildingTable;
}

} // namespace trembler::ui
