#include "game/ui/cards/play_cards.hpp"
#include "game/ui/shared/words.hpp"
#include "render/panels/theme.hpp"

#include <initializer_list>

namespace trembler::ui {
namespace {

using namespace render;

/// How the buttons at the bottom share the width of the window; lengths in pixels at UI scale 1.
struct BottomRow {
    float gap = 7;
    float runWidth = 168;
    float speedWidth = 60;
    bool runIcon = true;
    Anchor transport = Anchor::Bottom;
};

BottomRow bottomRowHere() {
    float const screen = ImGui::GetIO().DisplaySize.x / theme().scale;
    BottomRow row;
    if (screen < roomyWidth) { // the tools at the left reach the middle's buttons
        row.transport = Anchor::BottomRight;
    }
    if (screen < 904) {
        row = {4, 108, 50, false, Anchor::BottomRight};
    }
    return row;
}

void next() {
    ImGui::SameLine(0, scaled(bottomRowHere().gap));
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

void drawTransport(CommandButtons& buttons, TransportLook const& look) {
    Layout& layout = buttons.layout();
    BottomRow const bottom = bottomRowHere();
    layout.beginCard("transport", "", {.anchor = bottom.transport, .bare = true});
    // Every button keeps its place, so that none comes to lie under a mouse that clicks another one twice.
    row(buttons, {"undo", "redo", "step"});
    next();
    buttons.big("run", {.item = look.building ? "run" : "stop",
                        .look = ButtonLook::Primary,
                        .width = bottom.runWidth,
                        .withIcon = bottom.runIcon});
    next();
    row(buttons, {"pause", "slower"});
    next();
    std::string const label = words::timesReal(look.speed);
    buttons.big("normal-speed", {.label = label.c_str(),
                                 .look = look.late ? ButtonLook::Danger : ButtonLook::Quiet,
                                 .width = bottom.speedWidth,
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

void drawCorner(CommandButtons& buttons, bool ran) {
    Layout& layout = buttons.layout();
    layout.beginCard("corner", "", {.anchor = Anchor::TopRight, .bare = true});
    if (ran) { // at the left, so that the others keep their places
        buttons.icon("timeline");
        next();
    }
    row(buttons, {"fit", "save", "picture", "record", "help", "levels", "menu"});
    layout.endCard();
}

} // namespace trembler::ui
