#include "game/ui/app/menu/keys_page.hpp"

#include "game/ui/shared/commands/key_help.hpp"
#include "game/ui/shared/commands/named_keys.hpp"
#include "game/ui/shared/texts.hpp"
#include "game/ui/shared/words.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/buttons.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>

namespace trembler::ui {
namespace {

using namespace render;

constexpr float keyRowHeight = 32;

void drawKeyRow(CommandInfo const& command, std::string const& keys, bool waiting, bool hovered) {
    ImVec2 const low = ImGui::GetItemRectMin();
    ImVec2 const high = ImGui::GetItemRectMax();
    auto& list = *ImGui::GetWindowDrawList();
    if (waiting || hovered) {
        Colour const ground =
            waiting ? mix(palette::paperShade, palette::accent, 0.25F) : palette::paperShade;
        list.AddRectFilled(low, high, imColour(ground), scaled(8));
    }
    float const y = 0.5F * (low.y + high.y - ImGui::GetTextLineHeight());
    list.AddText({low.x + scaled(10), y}, imColour(palette::ink), command.name);
    char const* const shown = waiting        ? text("keys.press")
                              : keys.empty() ? words::nothingStated
                                             : keys.c_str();
    Colour const colour = keys.empty() && !waiting ? palette::inkSoft : palette::accent;
    list.AddText({high.x - scaled(10) - ImGui::CalcTextSize(shown).x, y}, imColour(colour), shown);
}

} // namespace

bool KeysPage::cancel() {
    bool const was = waiting();
    waiting_ = nullptr;
    complaint_.clear();
    return was;
}

void KeysPage::cancelByEscape(UiContext const& context) {
    bool const takesIt = waiting_ != nullptr && std::find(waiting_->keys.begin(), waiting_->keys.end(),
                                                          Chord{SDLK_ESCAPE}) != waiting_->keys.end();
    if (context.input.keyPressed(SDLK_ESCAPE) && !takesIt) {
        cancel();
    }
}

void KeysPage::takeKey(UiContext& context) {
    for (SDL_Event const& event : context.input.events()) {
        if (!waiting() || event.type != SDL_KEYDOWN || event.key.repeat != 0 ||
            isModifier(event.key.keysym.sym)) {
            continue;
        }
        if (auto const why = context.keys.bind(*waiting_, chordOf(event.key.keysym))) {
            complaint_ = *why + ". " + text("keys.another");
            continue;
        }
        cancel();
        context.profile.setKeys(context.keys.stated());
    }
}

void KeysPage::drawRow(UiContext& context, CommandInfo const& command) {
    std::string const id(command.id);
    float const button = scaled(keyRowHeight);
    float const width = ImGui::GetContentRegionAvail().x - button - scaled(8);
    bool chosen = ImGui::InvisibleButton(id.c_str(), {width, button});
    bool const hovered = ImGui::IsItemHovered();
    context.layout.item("key of " + id);
    chosen = context.focus.item() || chosen;
    bool none = context.focus.here() && !taking_ &&
                (context.menuKeys.pressed(MenuKey::erase) || context.menuKeys.pressed(MenuKey::type));
    bool const waits = waiting_ == &command;
    drawKeyRow(command, labelsOf(context.keys.keysOf(command.id)), waits, hovered);
    if (hovered && !waits && command.tip != command.name) { // the tip would hide what the row asks for
        ImGui::SetTooltip("%s", words::wrapped(shownTip(command, false, context.keys), 60).c_str());
    }
    if (!command.essential) {
        ImGui::SameLine(0, scaled(4));
        ImVec2 const at = ImGui::GetCursorScreenPos();
        none = ImGui::InvisibleButton(("none " + id).c_str(), {button, button}) || none;
        context.layout.item("no key for " + id);
        drawIcon(*ImGui::GetWindowDrawList(), Icon::Cross, {at.x + 0.5F * button, at.y + 0.5F * button},
                 scaled(11), imColour(ImGui::IsItemHovered() ? palette::warning : palette::inkSoft));
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s", text("keys.none"));
        }
    }
    if (none) {
        cancel();
        if (auto const why = context.keys.unbind(command)) {
            complaint_ = *why + ".";
        }
        context.profile.setKeys(context.keys.stated());
    } else if (chosen) {
        complaint_.clear();
        waiting_ = &command;
    }
}

void KeysPage::drawRows(UiContext& context) {
    CommandInfo const* before = nullptr;
    for (CommandInfo const* command : context.keys.inGroups()) {
        if (before == nullptr || before->group != command->group) {
            ImGui::Dummy({0, scaled(2)});
            ImGui::PushFont(theme().fonts.strong);
            ImGui::PushStyleColor(ImGuiCol_Text, imColour4(palette::accent));
            ImGui::TextUnformatted(titleOf(command->group));
            ImGui::PopStyleColor();
            ImGui::PopFont();
        }
        before = command;
        drawRow(context, *command);
    }
}

/// Esc ends the question whatever it is bound to, see cancelByEscape().
std::string KeysPage::captionNow(UiContext const& context) const {
    if (waiting()) {
        return textWith("keys.press_or_esc", labelOf({SDLK_ESCAPE}));
    }
    return textWith("keys.hint", namedKeys({"menu-press"}, context.keys),
                    namedKeys({"menu-erase", "menu-type"}, context.keys));
}

bool KeysPage::draw(UiContext& context) {
    taking_ = waiting();
    if (taking_) {
        takeKey(context);
    }
    Layout& layout = context.layout;
    layout.beginCard("key bindings", text("keys.change"), {.anchor = Anchor::Middle, .width = 560});
    ImGui::PushFont(theme().fonts.small);
    caption(captionNow(context).c_str());
    ImGui::PushStyleColor(ImGuiCol_Text, imColour4(palette::warning));
    ImGui::TextUnformatted(complaint_.c_str());
    ImGui::PopStyleColor();
    ImGui::PopFont();
    float const screen = ImGui::GetIO().DisplaySize.y / theme().scale;
    ImGui::PushStyleColor(ImGuiCol_ChildBg, ImVec4(0, 0, 0, 0));
    ImGui::BeginChild("commands", {0, scaled(std::clamp(screen - 290, 160.F, 560.F))});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(scaled(4), scaled(2)));
    drawRows(context);
    ImGui::PopStyleVar();
    ImGui::EndChild();
    ImGui::PopStyleColor();
    float const half = (ImGui::GetContentRegionAvail().x - scaled(8)) / 2 / theme().scale;
    bool reset = bigButton(text("keys.reset"),
                           {.icon = Icon::Undo, .width = half, .enabled = !context.keys.isDefault()});
    layout.item("reset keys");
    reset = context.focus.item() || reset;
    if (reset) {
        cancel();
        context.keys.reset();
        context.profile.setKeys({});
    }
    ImGui::SameLine(0, scaled(8));
    bool leave = bigButton(text("menu.back"), {.icon = Icon::Back, .width = half});
    layout.item("close keys");
    leave = context.focus.item() || leave;
    layout.endCard();
    if (leave) {
        cancel();
    }
    return leave;
}

} // namespace trembler::ui
