#include "game/ui/cards/play_cards.hpp"
#include "game/ui/commands/asked_twice.hpp"
#include "game/ui/play/run/run_control.hpp"
#include "game/ui/shared/words.hpp"
#include "render/panels/theme.hpp"

#include <initializer_list>

namespace trembler::ui {
namespace {

using namespace render;

constexpr float runWidth = 168;

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

void drawTransport(CommandButtons& buttons, RunControl const& run, AskedTwice const& allBack) {
    Layout& layout = buttons.layout();
    layout.beginCard("transport", "", {.anchor = Anchor::Bottom, .bare = true});
    if (run.building()) {
        row(buttons, {"undo", "redo"});
        next();
        buttons.big("run", {.look = ButtonLook::Primary, .width = runWidth});
        next();
        if (allBack.waiting()) {
            buttons.big("all-back",
                        {.label = words::allBackAsk, .look = ButtonLook::Danger, .withIcon = false});
        } else {
            row(buttons, {"all-back", "step"});
        }
    } else {
        row(buttons, {"pause", "step"});
        next();
        buttons.big("run", {.item = "stop", .look = ButtonLook::Primary, .width = runWidth});
        next();
        row(buttons, {"fast", "record"});
    }
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
    if (session.mode() != SessionMode::building) {
        next();
        buttons.icon("cut");
    }
    layout.endCard();
}

void drawCorner(CommandButtons& buttons) {
    Layout& layout = buttons.layout();
    layout.beginCard("corner", "", {.anchor = Anchor::TopRight, .bare = true});
    row(buttons, {"fit", "save", "picture", "help", "levels", "menu"});
    layout.endCard();
}

} // namespace trembler::ui
