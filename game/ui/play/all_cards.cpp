#include "game/ui/play/all_cards.hpp"

#include "game/ui/cards/play_cards.hpp"
#include "game/ui/shared/words.hpp"

#include <algorithm>

namespace trembler::ui {
namespace {

void takeFromToolbox(PlayParts& parts, std::string const& part) {
    auto const& carried = parts.placing.carried();
    if (carried && !carried->number && carried->landing.part == part) {
        parts.placing.cancel(); // a second click on its tile puts it back
    } else {
        parts.placing.take(part, parts.pointer);
    }
    parts.mouse.tookPart();
}

std::string keyOf(KeyBindings const& bindings, std::string_view command) {
    auto const keys = bindings.keysOf(command);
    return keys.empty() ? std::string() : labelOf(keys.front());
}

/// The components panel or that of mods, between the cards at the top of the screen and the row of tools.
void drawPanels(PlayParts& parts, float screen) {
    UiContext& context = parts.context;
    float top = 150;
    for (char const* above : {"goal", "success"}) {
        if (auto const card = context.layout.card(above)) {
            top = std::max(top, static_cast<float>(card->high.y) / context.window.uiScale() + cardGap);
        }
    }
    parts.budget.watch(parts.components.open());
    if (parts.components.open() && parts.budget.stale(parts.session.world())) {
        parts.budget.look(parts.session.world());
    }
    std::string const less = keyOf(context.keys, "less-budget");
    std::string const more = keyOf(context.keys, "more-budget");
    bool const keys = !less.empty() && !more.empty();
    parts.components.setTips({withKey(words::budgetTip, "budget", context.keys),
                              words::lessOrMore + (keys ? " (" + less + ", " + more + ")" : std::string())});
    parts.components.draw(context.layout, parts.session, parts.budget, context.toasts, top,
                          screen - top - bottomRow - 8);
    if (!parts.hasMods()) {
        return;
    }
    World const* const world = &parts.session.world();
    parts.modsPanel.draw(context.layout, parts.data->registry, *parts.workshop, parts.session, top,
                         screen - top - bottomRow - 8);
    if (&parts.session.world() != world) { // built again, as the player has changed a script
        parts.newWorld();
    }
}

} // namespace

std::optional<std::size_t> drawPlayCards(PlayParts& parts, CommandSet const& commands) {
    UiContext& context = parts.context;
    parts.said.follow();
    Layout& layout = context.layout;
    Session const& session = parts.session;
    CommandButtons buttons(layout, context.keys, commands);
    drawGoalCard(layout, session,
                 {.said = &parts.said,
                  .hintsShown = parts.hintsShown,
                  .brief = parts.components.open() || parts.modsPanel.open()},
                 &buttons);
    drawCorner(buttons);
    if (parts.run.building() && !parts.inspector.open()) {
        std::string const hint =
            words::toolboxHint(keyOf(context.keys, "turn-left"), keyOf(context.keys, "turn-right"));
        if (auto const part = drawToolbox(buttons, session, parts.catalog(), parts.placing, hint,
                                          parts.allBack, parts.wires.laying())) {
            takeFromToolbox(parts, *part);
        }
    }
    drawTransport(buttons, parts.run);
    drawTools(buttons, session, parts.hasMods());
    bool const boxed = !session.level().toolbox.empty() || session.level().wires > 0;
    bool const done = !session.placed().empty() || !session.wires().empty() || !session.inputs().empty();
    drawSuccess(buttons, session, parts.celebration,
                {.narrow = boxed && !parts.inspector.open(),
                 .confetti = done && !context.profile.settings().reducedMotion});
    float const screen = static_cast<float>(context.window.size().height) / context.window.uiScale();
    parts.inspector.draw(layout, session, cornerRow, screen - cornerRow - bottomRow - 8);
    drawPanels(parts, screen);
    return buttons.asked();
}

} // namespace trembler::ui
