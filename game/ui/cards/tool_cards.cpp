#include "game/ui/cards/play_cards.hpp"
#include "game/ui/shared/words.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/buttons.hpp"
#include "render/panels/theme.hpp"

namespace trembler::ui {
namespace {

using namespace render;

/// A square button that asks for a command.
void ask(Layout& layout, std::optional<Command>& asked, Command command, char const* name, Icon icon,
         char const* tip, bool on = false, bool enabled = true) {
    if (iconButton(name, icon, tip, on, enabled)) {
        asked = command;
    }
    layout.item(name);
}

void next() {
    ImGui::SameLine(0, scaled(7));
}

} // namespace

std::optional<Command> drawTransport(Layout& layout, Session const& session, PlayState const& state) {
    std::optional<Command> asked;
    bool const building = session.mode() == SessionMode::building;
    layout.beginCard("transport", "", {.anchor = Anchor::Bottom, .bare = true});
    if (building) {
        ask(layout, asked, Command::undo, "undo", Icon::Undo, words::undoTip, false, session.canUndo());
        next();
        ask(layout, asked, Command::redo, "redo", Icon::Redo, words::redoTip, false, session.canRedo());
        next();
        if (bigButton(
                words::run,
                {.icon = Icon::Play, .look = ButtonLook::Primary, .width = 168, .tip = words::runTip})) {
            asked = Command::runOrStop;
        }
        layout.item("run");
        next();
        if (state.askAllBack) {
            if (bigButton(words::allBackAsk, {.look = ButtonLook::Danger, .tip = words::allBackTip})) {
                asked = Command::allBack;
            }
            layout.item("all back");
        } else {
            ask(layout, asked, Command::allBack, "all back", Icon::Reset, words::allBackTip, false,
                !session.placed().empty());
            next();
            ask(layout, asked, Command::step, "step", Icon::Step, words::stepTip);
        }
    } else {
        bool const running = session.mode() == SessionMode::running;
        ask(layout, asked, Command::pauseOrGo, "pause", running ? Icon::Pause : Icon::Play,
            running ? words::pauseTip : words::resumeTip, !running);
        next();
        ask(layout, asked, Command::step, "step", Icon::Step, words::stepTip);
        next();
        if (bigButton(
                words::stop,
                {.icon = Icon::Stop, .look = ButtonLook::Primary, .width = 168, .tip = words::stopTip})) {
            asked = Command::runOrStop;
        }
        layout.item("stop");
        next();
        ask(layout, asked, Command::fastForward, "fast", Icon::FastForward, words::fastTip, state.fast);
        next();
        ask(layout, asked, Command::record, "record", Icon::Record,
            state.recording ? words::recordStopTip : words::recordTip, state.recording);
    }
    layout.endCard();
    return asked;
}

std::optional<Command> drawTools(Layout& layout, Session const& session, PlayState const& state) {
    std::optional<Command> asked;
    layout.beginCard("tools", "", {.anchor = Anchor::BottomLeft, .bare = true});
    ask(layout, asked, Command::electricity, "electricity", Icon::Bolt, words::electricityTip,
        state.electricity);
    next();
    ask(layout, asked, Command::magnetism, "magnetism", Icon::Magnet, words::magnetismTip, state.magnetism);
    next();
    ask(layout, asked, Command::contacts, "contacts", Icon::Contact, words::contactsTip, state.contacts);
    next();
    ask(layout, asked, Command::names, "names", Icon::Eye, words::namesTip, state.names);
    next();
    ask(layout, asked, Command::components, "components", Icon::Gauge, words::componentsTip,
        state.components);
    if (session.mode() != SessionMode::building) {
        next();
        ask(layout, asked, Command::cut, "cut", Icon::Scissors, words::cutTip, state.cutting);
    }
    layout.endCard();
    return asked;
}

std::optional<Command> drawCorner(Layout& layout) {
    std::optional<Command> asked;
    layout.beginCard("corner", "", {.anchor = Anchor::TopRight, .bare = true});
    ask(layout, asked, Command::fit, "fit", Icon::Fit, words::fitTip);
    next();
    ask(layout, asked, Command::save, "save", Icon::Save, words::saveTip);
    next();
    ask(layout, asked, Command::picture, "picture", Icon::Camera, words::pictureTip);
    next();
    ask(layout, asked, Command::help, "help", Icon::Why, words::helpTip);
    next();
    ask(layout, asked, Command::levels, "levels", Icon::List, words::levelsTip);
    next();
    ask(layout, asked, Command::menu, "menu", Icon::Menu, words::menuTip);
    layout.endCard();
    return asked;
}

void drawHelp(Layout& layout, bool& open) {
    layout.beginCard("help", words::keys, {.anchor = Anchor::Middle, .width = 560});
    ImGui::PushFont(theme().fonts.small);
    constexpr auto count = static_cast<int>(std::size(words::keyHelp));
    if (ImGui::BeginTable("keys", 4, ImGuiTableFlags_SizingStretchProp)) {
        for (char const* column : {"a", "b", "c", "d"}) {
            ImGui::TableSetupColumn(column, ImGuiTableColumnFlags_WidthStretch,
                                    *column % 2 == 1 ? 0.19F : 0.31F);
        }
        int const half = (count + 1) / 2;
        for (int row = 0; row < half; ++row) {
            ImGui::TableNextRow();
            for (int i : {row, row + half}) {
                if (i >= count) {
                    continue;
                }
                ImGui::TableNextColumn();
                ImGui::PushStyleColor(ImGuiCol_Text, imColour4(palette::accent));
                ImGui::TextWrapped("%s", words::keyHelp[i].keys);
                ImGui::PopStyleColor();
                ImGui::TableNextColumn();
                ImGui::TextWrapped("%s", words::keyHelp[i].does);
            }
        }
        ImGui::EndTable();
    }
    ImGui::PopFont();
    ImGui::Dummy({0, scaled(4)});
    if (bigButton(words::back, {.icon = Icon::Back, .width = -1})) {
        open = false;
    }
    layout.item("close help");
    layout.endCard();
}

} // namespace trembler::ui
