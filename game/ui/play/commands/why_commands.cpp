#include "game/ui/play/commands/command_sections.hpp"
#include "render/window/gamepad.hpp"

namespace trembler::ui {
namespace {

using render::Icon;

bool canAsk(PlayParts const& parts) {
    return parts.why.canAsk();
}

bool canAskOfGoals(PlayParts const& parts) {
    return canAsk(parts) && !parts.session.judge().status().empty();
}

bool hasAnswer(PlayParts const& parts) {
    return parts.why.open() && parts.why.answer() != nullptr;
}

template <bool next>
void goToStep(PlayParts& parts) {
    if (auto const frame = parts.why.goToStep(next)) {
        parts.lookAt(*frame);
    }
}

constexpr Command<PlayParts> whyTable[] = {
    {.info = {.id = "why",
              .keys = {{{SDLK_y}}},
              .pad = {render::padKey(SDL_CONTROLLER_BUTTON_LEFTSTICK)},
              .icon = Icon::Why,
              .group = CommandGroup::running,
              .name = "Why?",
              .tip = "Ask what made the object under the pointer as it is, or else why a goal is met or not",
              .help = "why? (Shift: of a goal)",
              .padPhase = PadPhase::running},
     .run = [](PlayParts& parts) { parts.askWhy(); },
     .available = canAsk},
    {.info = {.id = "why-goal",
              .keys = {{{.key = SDLK_y, .shift = true}}},
              .pad = {render::padKey(SDL_CONTROLLER_BUTTON_BACK)},
              .icon = Icon::Why,
              .group = CommandGroup::running,
              .name = "Why? (goal)",
              .tip = "Ask why a goal is met, or how nearly it was; once more: the next goal",
              .help = "why? (Shift: of a goal)",
              .padPhase = PadPhase::running},
     .run =
         [](PlayParts& parts) {
             parts.inspector.close();
             parts.why.askNextGoal();
         },
     .available = canAskOfGoals},
    {.info = {.id = "why-before",
              .keys = {{{SDLK_a}}},
              .group = CommandGroup::running,
              .name = "Cause before",
              .tip = "Look at the step before in the chain of causes",
              .help = "look at the causes one by one"},
     .run = goToStep<false>,
     .available = hasAnswer},
    {.info = {.id = "why-next",
              .keys = {{{SDLK_d}}},
              .pad = {render::padKey(SDL_CONTROLLER_BUTTON_RIGHTSTICK)},
              .group = CommandGroup::running,
              .name = "Next cause",
              .tip = "Look at the next step in the chain of causes",
              .help = "look at the causes one by one",
              .padPhase = PadPhase::running},
     .run = goToStep<true>,
     .available = hasAnswer},
};

} // namespace

std::span<Command<PlayParts> const> whyCommands() {
    return whyTable;
}

} // namespace trembler::ui
