#include "game/ui/cards/play_cards.hpp"
#include "game/ui/play/run/run_control.hpp"
#include "game/ui/shared/words.hpp"
#include "render/panels/theme.hpp"

#include <initializer_list>

namespace trembler::ui {
namespace {

using namespace render;

constexpr float runWidth = 168;
constexpr float speedWidth = 60;

void next() {
    ImGui::SameLine(0, scaled(7));
}

/// Draws the buttons side by side.
void row(CommandButtons& buttons, std::initializer_list<char const*> ids) {
    bool first = true;
    for (char const* id : ids) {
        if (!first) {
            next();
        }
        first = false;
        buttons.icon(id);
    }
}

} // namespace

void drawTransport(CommandButtons& buttons, RunControl const& run) {
    Layout& layout = buttons.layout();
    layout.beginCard("transport", "", {.anchor = Anchor::Bottom, .bare = true});
    // Every button keeps its place, so that none comes to lie under a mouse that clicks another one twice.
    row(buttons, {"undo", "redo", "step"});
    next();
    buttons.big("run",
                {.item = run.building() ? "run" : "stop", .look = ButtonLook::Primary, .width = runWidth});
    next();
    row(buttons, {"pause", "slower"});
    next();
    Speed const& speed = run.speed();
    std::string const label = words::timesReal(speed.now());
    bool const late = speed.onlyReached().has_value();
    buttons.big("normal-speed", {.label = label.c_str(),
                                 .look = late ? ButtonLook::Danger : ButtonLook::Quiet,
                                 .width = speedWidth,
                                 .withIcon = false});
    next();
    row(buttons, {"faster"});
    layout.endCard();
}

void drawTools(CommandButtons& buttons, Session const& session, bool mods) {
    Layout& layout = buttons.layout();
    layout.beginCard("tools", "", {.anchor = Anchor::BottomLeft, .bare = true});
    row(buttons, {"electricity", "magnetism", "contacts", "names", "components"});
    if (mods) {
        next();
        buttons.icon("mods");
    }
    if (session.mode() != SessionMode::building || session.level().wires > 0) {
        next();
        buttons.icon("cut");
    }
    layout.endCard();
}

void drawCorner(CommandButtons& buttons) {
    Layout& layout = buttons.layout();
    layout.beginCard("corner", "", {.anchor = Anchor::TopRight, .bare = true});
    row(buttons, {"fit", "save", "picture", "record", "help", "levels", "menu"});
    layout.endCard();
}

} // namespace trembler::ui
