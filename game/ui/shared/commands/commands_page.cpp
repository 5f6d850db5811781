#include "game/ui/shared/commands/commands_page.hpp"

#include "game/ui/shared/commands/key_bindings.hpp"
#include "game/ui/shared/commands/key_help.hpp"
#include "game/ui/shared/commands/named_keys.hpp"
#include "game/ui/shared/texts.hpp"
#include "game/ui/shared/words.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/buttons.hpp"
#include "render/panels/cards.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace trembler::ui {
namespace {

using namespace render;

constexpr float commandRowHeight = 32;

/// The commands of a list that can be run now, sorted by group.
std::vector<std::size_t> runnable(CommandSet const& commands) {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < commands.size(); ++i) {
        CommandInfo const& info = commands.info(i);
        if (commands.available(i) && !info.leads && info.use != KeyUse::held) {
            all.push_back(i);
        }
    }
    std::stable_sort(all.begin(), all.end(), [&](std::size_t a, std::size_t b) {
        return commands.info(a).group < commands.info(b).group;
    });
    return all;
}

void drawGroup(CommandGroup group) {
    ImGui::Dummy({0, scaled(2)});
    ImGui::PushFont(theme().fonts.strong);
    ImGui::PushStyleColor(ImGuiCol_Text, imColour4(palette::accent));
    ImGui::TextUnformatted(titleOf(group));
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

/// Returns whether it was chosen.
bool drawCommand(UiContext& context, CommandSet const& commands, std::size_t index) {
    CommandInfo const& info = commands.info(index);
    std::string const id(info.id);
    bool const on = commands.on(index);
    bool const pressed = ImGui::InvisibleButton(
        id.c_str(), {ImGui::GetContentRegionAvail().x - scaled(6), scaled(commandRowHeight)});
    bool const hovered = ImGui::IsItemHovered();
    context.layout.item("command " + id);
    bool const chosen = context.focus.item() || pressed;
    ImVec2 const low = ImGui::GetItemRectMin();
    ImVec2 const high = ImGui::GetItemRectMax();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (hovered) {
        list.AddRectFilled(low, high, imColour(palette::paperShade), scaled(8));
    }
    float const y = 0.5F * (low.y + high.y - ImGui::GetTextLineHeight());
    if (on) {
        drawIcon(list, Icon::Tick, {low.x + scaled(14), 0.5F * (low.y + high.y)}, scaled(12),
                 imColour(palette::goal));
    }
    char const* const name = on && info.whenOn.name != nullptr ? info.whenOn.name : info.name;
    list.AddText({low.x + scaled(28), y}, imColour(palette::ink), name);
    std::string const keys = labelsOf(context.keys.keysOf(info.id));
    list.AddText({high.x - scaled(10) - ImGui::CalcTextSize(keys.c_str()).x, y}, imColour(palette::inkSoft),
                 keys.c_str());
    if (hovered) {
        ImGui::SetTooltip("%s", words::wrapped(shownTip(info, on, context.keys), 60).c_str());
    }
    return chosen;
}

} // namespace

CommandsPage::Choice CommandsPage::draw(UiContext& context, CommandSet const& commands) {
    Choice choice;
    Layout& layout = context.layout;
    layout.beginCard("all commands", text("menu.commands"), {.anchor = Anchor::Middle, .width = 560});
    smallCaption(text("commands.hint"));
    float const screen = ImGui::GetIO().DisplaySize.y / theme().scale;
    ImGui::PushStyleColor(ImGuiCol_ChildBg, ImVec4(0, 0, 0, 0));
    ImGui::BeginChild("commands", {0, scaled(std::clamp(screen - 260, 160.F, 560.F))});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(scaled(4), scaled(2)));
    std::optional<CommandGroup> before;
    for (std::size_t const index : runnable(commands)) {
        if (before != commands.info(index).group) {
            before = commands.info(index).group;
            drawGroup(*before);
        }
        if (drawCommand(context, commands, index)) {
            choice.command = index;
        }
    }
    ImGui::PopStyleVar();
    ImGui::EndChild();
    ImGui::PopStyleColor();
    float const half = (ImGui::GetContentRegionAvail().x - scaled(8)) / 2 / theme().scale;
    bool const keys = bigButton(text("keys.change"), {.icon = Icon::Settings, .width = half});
    layout.item("change keys");
    choice.changeKeys = context.focus.item() || keys;
    ImGui::SameLine(0, scaled(8));
    bool const back = bigButton(text("menu.back"), {.icon = Icon::Back, .width = half});
    layout.item("close commands");
    choice.back = context.focus.item() || back;
    layout.endCard();
    return choice;
}

} // namespace trembler::ui
