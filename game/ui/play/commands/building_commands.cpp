#include "game/ui/play/commands/command_sections.hpp"
#include "game/ui/play/whatif/what_if_tool.hpp"
#include "game/ui/shared/words.hpp"
#include "render/window/gamepad.hpp"

namespace trembler::ui {
namespace {

using render::Icon;

/// Whether keys act on the object chosen at the moment of a what-if.
bool changesPast(PlayParts const& parts) {
    return parts.whatIf->atMoment();
}
/// Whether a part is in the hand or selected, so that keys can turn it, move it and put it back.
bool partAtHand(PlayParts const& parts) {
    if (changesPast(parts)) {
        return !parts.whatIfTool->chosen().empty();
    }
    return parts.run.building() && (parts.placing.carried() || parts.placing.selected() || parts.group.any());
}
bool isBuilding(PlayParts const& parts) {
    return parts.run.building();
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
    if (changesPast(parts)) {
        parts.whatIfTool->turn(steps, parts.context.shiftHeld());
        return;
    }
    place(parts, [&](auto& tool) { tool.turn(steps, parts.context.shiftHeld()); });
}

void putBack(PlayParts& parts) {
    if (changesPast(parts)) {
        parts.whatIfTool->remove();
    } else {
        place(parts, [](auto& tool) { tool.putBack(); });
    }
}

/// Moves the selected parts; if there are none, or one is in the hand, the pointer.
template <int x, int y>
void nudge(PlayParts& parts) {
    if (parts.movesView) {
        parts.view.look({x * viewStep, y * viewStep});
        return;
    }
    if (changesPast(parts) && !parts.whatIfTool->chosen().empty() && !parts.keyPointer.active()) {
        parts.whatIfTool->nudge({x, y}, parts.context.shiftHeld());
        return;
    }
    if (y == 0 && parts.run.paused() && parts.timeline.shown() && !parts.keyPointer.active()) {
        parts.timeline.stepBy(parts.context.shiftHeld() ? 10 * x : x);
        return;
    }
    bool const selected =
        parts.run.building() && !parts.placing.carried() && (parts.placing.selected() || parts.group.any());
    if (!selected || parts.keyPointer.active()) {
        parts.keyPointer.move({x, y}, parts.context.shiftHeld(), parts.pointer, parts.camera());
        return;
    }
    place(parts, [&](auto& tool) { tool.nudge({x, y}, parts.context.shiftHeld()); });
}

/// Takes the next part out of the toolbox, of those that are shown, after the one in the hand, `by` entries
/// on; after the last one the hand is empty.
template <int by>
void takeNext(PlayParts& parts) {
    auto const slots = parts.shownTools();
    int const count = static_cast<int>(slots.size());
    auto const& carried = parts.placing.carried();
    int now = by > 0 ? -1 : count;
    for (int i = 0; carried && !carried->number && i < count; ++i) {
        now = slots[static_cast<std::size_t>(i)].part == carried->landing.part ? i : now;
    }
    for (int next = now + by; next >= 0 && next < count; next += by) {
        ToolboxSlot const& slot = slots[static_cast<std::size_t>(next)];
        if (slot.left > 0) {
            parts.takeByKey(slot.part);
            return;
        }
    }
    parts.placing.cancel();
    parts.group.reset();
    parts.wires.reset();
}

bool hasLargeToolbox(PlayParts const& parts) {
    return parts.run.building() && ToolboxView::large(parts.session.toolbox());
}

char const* whyNoGroups(PlayParts const& parts) {
    return parts.run.building() ? words::allInSight : nullptr;
}

/// The toolbox comes back if a panel has its place, in a small window.
void showToolbox(PlayParts& parts) {
    if (parts.context.layout.card("toolbox")) {
        return;
    }
    if (parts.components.open()) {
        parts.components.toggle();
    }
    parts.modsPanel.setOpen(false);
}

void findPart(PlayParts& parts) {
    showToolbox(parts);
    parts.toolbox.askForKeys();
}

template <int by>
void nextGroup(PlayParts& parts) {
    showToolbox(parts);
    parts.toolbox.chooseNext(ToolboxView::groupsIn(parts.session.toolbox(), parts.catalog()), by);
}

/// Why a part cannot be turned, mirrored or put back.
char const* whyNothingAtHand(PlayParts const& parts) {
    return parts.run.building() ? words::nothingInHand : nullptr;
}

void duplicate(PlayParts& parts) {
    World const* const world = &parts.session.world();
    parts.group.duplicate();
    if (world != &parts.session.world()) {
        parts.newWorld();
    }
}

/// Adds the part at the pointer to the chosen ones, as Shift with a click does.
void chooseMore(PlayParts& parts) {
    auto const number = parts.session.numberOf(parts.picking.hovered());
    if (number && !parts.placing.carried()) {
        parts.group.toggle(*number);
    }
}

constexpr Command<PlayParts> buildingTable[] = {
    {.info = {.id = "turn-left",
              .keys = {{{SDLK_q}}},
              .pad = {render::padKey(SDL_CONTROLLER_BUTTON_LEFTSTICK)},
              .use = KeyUse::repeats,
              .icon = Icon::TurnLeft,
              .group = CommandGroup::building,
              .name = "Turn left",
              .tip = "Turn the part in hand to the left by 15°, with Shift by 1°",
              .help = "turn the part in hand (Shift: 1°)",
              .padPhase = PadPhase::building},
     .run = turn<1>,
     .available = partAtHand,
     .whyNot = whyNothingAtHand},
    {.info = {.id = "turn-right",
              .keys = {{{SDLK_e}}},
              .pad = {render::padKey(SDL_CONTROLLER_BUTTON_RIGHTSTICK)},
              .use = KeyUse::repeats,
              .icon = Icon::TurnRight,
              .group = CommandGroup::building,
              .name = "Turn right",
              .tip = "Turn the part in hand to the right by 15°, with Shift by 1°",
              .help = "turn the part in hand (Shift: 1°)",
              .padPhase = PadPhase::building},
     .run = turn<-1>,
     .available = partAtHand,
     .whyNot = whyNothingAtHand},
    {.info = {.id = "flip",
              .keys = {{{SDLK_v}}},
              .pad = {render::padRightStickUp},
              .icon = Icon::Flip,
              .group = CommandGroup::building,
              .name = "Flip",
              .tip = "Mirror the part in hand, or the chosen parts, from left to right",
              .help = "mirror the part in hand",
              .padPhase = PadPhase::building},
     .run = [](PlayParts& parts) { place(parts, [](auto& tool) { tool.flip(); }); },
     .available = [](PlayParts const& parts) { return partAtHand(parts) && parts.run.building(); },
     .whyNot = whyNothingAtHand},
    {.info = {.id = "move-left",
              .keys = {{{SDLK_LEFT}}},
              .pad = {render::padKey(SDL_CONTROLLER_BUTTON_DPAD_LEFT)},
              .use = KeyUse::repeats,
              .group = CommandGroup::building,
              .name = "Move left",
              .tip = "Move the selected part, or else the pointer, to the left; with Shift by less",
              .help = "move the selected part or the pointer (Shift: finer)"},
     .run = nudge<-1, 0>},
    {.info = {.id = "move-right",
              .keys = {{{SDLK_RIGHT}}},
              .pad = {render::padKey(SDL_CONTROLLER_BUTTON_DPAD_RIGHT)},
              .use = KeyUse::repeats,
              .group = CommandGroup::building,
              .name = "Move right",
              .tip = "Move the selected part, or else the pointer, to the right; with Shift by less",
              .help = "move the selected part or the pointer (Shift: finer)"},
     .run = nudge<1, 0>},
    {.info = {.id = "move-up",
              .keys = {{{SDLK_UP}}},
              .pad = {render::padKey(SDL_CONTROLLER_BUTTON_DPAD_UP)},
              .use = KeyUse::repeats,
              .group = CommandGroup::building,
              .name = "Move up",
              .tip = "Move the selected part, or else the pointer, up; with Shift by less",
              .help = "move the selected part or the pointer (Shift: finer)"},
     .run = nudge<0, 1>},
    {.info = {.id = "move-down",
              .keys = {{{SDLK_DOWN}}},
              .pad = {render::padKey(SDL_CONTROLLER_BUTTON_DPAD_DOWN)},
              .use = KeyUse::repeats,
              .group = CommandGroup::building,
              .name = "Move down",
              .tip = "Move the selected part, or else the pointer, down; with Shift by less",
              .help = "move the selected part or the pointer (Shift: finer)"},
     .run = nudge<0, -1>},
    {.info = {.id = "put-back",
              .keys = {{{SDLK_DELETE}}},
              .pad = {render::padKey(SDL_CONTROLLER_BUTTON_BACK)},
              .icon = Icon::Remove,
              .group = CommandGroup::building,
              .name = "Put back",
              .tip = "Put the part in hand back into the toolbox",
              .help = "put the part back",
              .padPhase = PadPhase::building},
     .run = putBack,
     .available = partAtHand,
     .whyNot = whyNothingAtHand},
    {.info = {.id = "next-part",
              .keys = {{{SDLK_t}}},
              .pad = {render::padRightTrigger},
              .group = CommandGroup::building,
              .name = "Next part",
              .tip = "Take the next part out of the toolbox",
              .help = "take the next, the previous part",
              .padPhase = PadPhase::building},
     .run = takeNext<1>,
     .available = isBuilding},
    {.info = {.id = "previous-part",
              .keys = {{{.key = SDLK_t, .shift = true}}},
              .pad = {render::padLeftTrigger},
              .group = CommandGroup::building,
              .name = "Previous part",
              .tip = "Take the previous part out of the toolbox",
              .help = "take the next, the previous part",
              .padPhase = PadPhase::building},
     .run = takeNext<-1>,
     .available = isBuilding},
    {.info = {.id = "find-part",
              .keys = {{withCtrl(SDLK_f), {SDLK_SLASH}, {SDLK_KP_DIVIDE}}},
              .group = CommandGroup::building,
              .name = "Find a part",
              .tip = "Find a part of a large toolbox by its name; Enter takes the first one",
              .help = "find a part by its name"},
     .run = findPart,
     .available = hasLargeToolbox,
     .whyNot = whyNoGroups},
    {.info = {.id = "next-group",
              .keys = {{{SDLK_s}}},
              .group = CommandGroup::building,
              .name = "Next group",
              .tip = "Show the next group of parts of a large toolbox",
              .help = "show the next, the previous group of parts"},
     .run = nextGroup<1>,
     .available = hasLargeToolbox,
     .whyNot = whyNoGroups},
    {.info = {.id = "previous-group",
              .keys = {{{.key = SDLK_s, .shift = true}}},
              .group = CommandGroup::building,
              .name = "Previous group",
              .tip = "Show the previous group of parts of a large toolbox",
              .help = "show the next, the previous group of parts"},
     .run = nextGroup<-1>,
     .available = hasLargeToolbox,
     .whyNot = whyNoGroups},
    {.info = {.id = "act",
              .keys = {{{SDLK_RETURN}, {SDLK_KP_ENTER}}},
              .pad = {render::padKey(SDL_CONTROLLER_BUTTON_A)},
              .use = KeyUse::held,
              .group = CommandGroup::building,
              .name = "Mouse button",
              .tip = "Acts as the mouse's button where the pointer is that keys move",
              .help = "place, take hold where the pointer is"},
     .run = [](PlayParts&) {}},
    {.info = {.id = "choose-all",
              .keys = {{withCtrl(SDLK_a)}},
              .group = CommandGroup::building,
              .name = "Choose all",
              .tip = "Choose all placed parts, to move, turn or put them back together",
              .help = "choose all parts"},
     .run = [](PlayParts& parts) { parts.group.chooseAll(); },
     .available =
         [](PlayParts const& parts) { return parts.run.building() && !parts.session.placed().empty(); },
     .whyNot = [](PlayParts const& parts) -> char const* {
         return parts.run.building() ? words::allThere : nullptr;
     }},
    {.info = {.id = "choose-more",
              .keys = {},
              .pad = {render::padRightStickDown},
              .group = CommandGroup::building,
              .name = "Choose this, too",
              .tip = "Add the part at the pointer to the chosen parts, or take it away from them",
              .help = "choose several parts",
              .padPhase = PadPhase::building},
     .run = chooseMore,
     .available = isBuilding},
    {.info = {.id = "duplicate",
              .keys = {{withCtrl(SDLK_d)}},
              .pad = {render::padRightStickRight},
              .group = CommandGroup::building,
              .name = "Duplicate",
              .tip = "Place another one of each chosen part, as far as the toolbox has them",
              .help = "place the same parts again",
              .padPhase = PadPhase::building},
     .run = duplicate,
     .available =
         [](PlayParts const& parts) {
             return partAtHand(parts) && parts.run.building() && !parts.placing.carried();
         },
     .whyNot = [](PlayParts const& parts) -> char const* {
         return parts.run.building() ? words::selectFirst : nullptr;
     }},
};

} // namespace

std::span<Command<PlayParts> const> buildingCommands() {
    return buildingTable;
}

} // namespace trembler::ui
