#include "game/ui/play/commands/command_sections.hpp"
#include "game/ui/play/whatif/what_if_tool.hpp"
#include "game/ui/shared/words.hpp"
#include "render/window/gamepad.hpp"

#include <algorithm>

namespace trembler::ui {
namespace {

using render::Icon;

constexpr double budgetStep = 1.25; // the factor by which a key changes the time budget

void hint(PlayParts& parts) {
    if (parts.said.hints().empty()) {
        parts.context.toasts.add(words::noHints);
    }
    parts.showHint();
}

/// The two panels lie in the same place.
void showComponents(PlayParts& parts) {
    parts.components.toggle();
    parts.modsPanel.setOpen(false);
}

void showMods(PlayParts& parts) {
    if (!parts.hasMods()) {
        parts.context.toasts.add(words::noMods);
        return;
    }
    parts.modsPanel.setOpen(!parts.modsPanel.open());
    if (parts.components.open()) {
        parts.components.toggle();
    }
}

bool hasWire(PlayParts const& parts) {
    return parts.session.level().wires > 0;
}

/// In a run any wire is cut; before it, the wires that the player has laid are put back.
void cut(PlayParts& parts) {
    if (parts.whatIf->atMoment()) {
        parts.whatIfTool->setCutting(!parts.whatIfTool->cutting());
    } else if (inARun(parts)) {
        parts.hand.setCutting(!parts.hand.cutting());
    } else {
        parts.placing.cancel();
        parts.group.cancel();
        parts.wires.switchCutting();
    }
}

char const* whyNoWire(PlayParts const& parts) {
    if (!hasWire(parts)) {
        return words::noWires;
    }
    return parts.run.building() ? words::noWireLeft : nullptr;
}

void layWires(PlayParts& parts) {
    parts.placing.reset();
    parts.group.reset();
    parts.wires.switchLaying();
}

constexpr Command<PlayParts> toolTable[] = {
    {.info = {.id = "cut",
              .keys = {{{SDLK_x}}},
              .pad = {render::padLeftTrigger},
              .icon = Icon::Scissors,
              .group = CommandGroup::running,
              .name = "Cut",
              .tip = "Cut a wire",
              .help = "cut a wire",
              .padPhase = PadPhase::running},
     .run = cut,
     .available = [](PlayParts const& parts) { return inARun(parts) || hasWire(parts); },
     .on =
         [](PlayParts const& parts) {
             return parts.hand.cutting() || parts.wires.cutting() || parts.whatIfTool->cutting();
         }},
    {.info = {.id = "second-hand",
              .keys = {{{SDLK_g}}},
              .pad = {render::padRightTrigger},
              .use = KeyUse::held,
              .group = CommandGroup::running,
              .name = "Second hand",
              .tip = "While it is held the mouse is a second hand, and the first one stays where it is",
              .help = "hold: the mouse is a second hand",
              .padPhase = PadPhase::running},
     .run = [](PlayParts&) {},
     .available = inARun},
    {.info = {.id = "wire",
              .keys = {{{SDLK_w}}},
              .pad = {render::padRightStickLeft},
              .icon = Icon::Bolt,
              .group = CommandGroup::building,
              .name = "Wire",
              .tip = "Lay a wire from one conductor to another",
              .help = "lay a wire",
              .padPhase = PadPhase::building},
     .run = layWires,
     .available =
         [](PlayParts const& parts) {
             return hasWire(parts) && parts.run.building() && parts.session.wiresLeft() > 0;
         },
     .on = [](PlayParts const& parts) { return parts.wires.laying(); },
     .whyNot = whyNoWire},
    {.info = {.id = "hint",
              .keys = {{{SDLK_h}}},
              .icon = Icon::Hint,
              .group = CommandGroup::building,
              .name = words::hint,
              .tip = "Show a hint",
              .help = "hint"},
     .run = hint,
     .available = [](PlayParts const& parts) { return parts.run.building(); }},
    {.info = {.id = "components",
              .keys = {{{SDLK_c}, {SDLK_F3}}},
              .icon = Icon::Gauge,
              .group = CommandGroup::looking,
              .name = words::components,
              .tip = "Components of the simulation",
              .help = "components and their times"},
     .run = showComponents,
     .on = [](PlayParts const& parts) { return parts.components.open(); }},
    {.info = {.id = "mods",
              .keys = {{{SDLK_m}}},
              .icon = Icon::Script,
              .group = CommandGroup::looking,
              .name = words::mods,
              .tip = "Scripts of the level's mods",
              .help = "mods, what their scripts do"},
     .run = showMods,
     .on = [](PlayParts const& parts) { return parts.modsPanel.open(); }},
    {.info = {.id = "budget",
              .keys = {{{SDLK_b}}},
              .group = CommandGroup::looking,
              .name = "Time budget",
              .tip = "Switch the time budget on or off",
              .help = "keep to a time budget"},
     .run = [](PlayParts& parts) { parts.context.toasts.add(switchBudget(parts.budget)); },
     .on = [](PlayParts const& parts) { return parts.budget.budget().has_value(); }},
    {.info = {.id = "less-budget",
              .keys = {{{SDLK_COMMA}}},
              .group = CommandGroup::looking,
              .name = "Less time",
              .tip = "A smaller time budget",
              .help = "a smaller or larger time budget"},
     .run = [](PlayParts& parts) { parts.context.toasts.add(changeBudget(parts.budget, 1 / budgetStep)); }},
    {.info = {.id = "more-budget",
              .keys = {{{SDLK_PERIOD}}},
              .group = CommandGroup::looking,
              .name = "More time",
              .tip = "A larger time budget",
              .help = "a smaller or larger time budget"},
     .run = [](PlayParts& parts) { parts.context.toasts.add(changeBudget(parts.budget, budgetStep)); }},
};

} // namespace

std::span<Command<PlayParts> const> toolCommands() {
    return toolTable;
}

} // namespace trembler::ui
