#include "game/ui/edit/panels/side_panel.hpp"

#include "game/ui/edit/edit_words.hpp"
#include "game/ui/edit/keys_owner.hpp"
#include "game/ui/edit/panels/bars.hpp"
#include "game/ui/edit/panels/tool_icons.hpp"
#include "game/ui/edit/study/study_words.hpp"
#include "game/ui/shared/commands/command_buttons.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>
#include <array>

namespace trembler::ui {
namespace {

using namespace render;

struct TabRow {
    Tab tab;
    char const* id;
};
constexpr std::array<TabRow, 9> tabRows{{{Tab::parts, "edit-parts"},
                                         {Tab::outline, "edit-outline"},
                                         {Tab::properties, "edit-properties"},
                                         {Tab::goals, "edit-goals"},
                                         {Tab::level, "edit-level"},
                                         {Tab::solutions, "edit-solutions"},
                                         {Tab::report, "edit-report"},
                                         {Tab::search, "edit-search"},
                                         {Tab::problems, "edit-problems"}}};

/// In the language in use. Not in the table above, which may be made before the words are.
char const* titleOf(Tab tab) {
    switch (tab) {
    case Tab::parts:
        return words::tabParts;
    case Tab::outline:
        return words::tabOutline;
    case Tab::properties:
        return words::tabProperties;
    case Tab::goals:
        return words::tabGoals;
    case Tab::level:
        return words::tabLevel;
    case Tab::solutions:
        return words::tabSolutions;
    case Tab::report:
        return words::tabReport;
    case Tab::search:
        return words::tabSearch;
    case Tab::problems:
        break;
    }
    return words::tabProblems;
}

/// The number of problems on the tab of their page.
void drawBadge(std::size_t count) {
    if (count == 0) {
        return;
    }
    ImVec2 const corner{ImGui::GetItemRectMax().x - scaled(3), ImGui::GetItemRectMin().y + scaled(3)};
    std::string const text = count > 99 ? "99" : std::to_string(count);
    ImGui::PushFont(theme().fonts.small);
    ImVec2 const size = ImGui::CalcTextSize(text.c_str());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({corner.x - size.x - scaled(5), corner.y}, {corner.x, corner.y + size.y},
                       imColour(palette::warning), scaled(6));
    list.AddText({corner.x - size.x - scaled(2.5F), corner.y}, imColour(palette::paperLight), text.c_str());
    ImGui::PopFont();
}

void drawTabs(EditParts& parts, CommandSet const& commands) {
    CommandButtons const buttons(parts.context.layout, parts.context.keys, commands);
    float const gap = 3;
    auto const count = static_cast<float>(tabRows.size());
    float const width = (ImGui::GetContentRegionAvail().x / theme().scale - (count - 1) * gap) / count;
    for (TabRow const& row : tabRows) {
        if (row.tab != Tab::parts) {
            ImGui::SameLine(0, scaled(gap));
        }
        if (tabButton(row.id, row.tab, buttons.tip(row.id).c_str(), parts.tab == row.tab, width)) {
            parts.tab = row.tab;
        }
        parts.context.layout.item(row.id);
        if (row.tab == Tab::problems) {
            drawBadge(parts.problems.all().size());
        }
    }
}

/// While the panel has the keyboard, or a menu is open, ImGui moves its own ring among the widgets. A list
/// that drops down moves its own mark.
void passKeyboard(EditParts const& parts) {
    ImGuiIO& io = ImGui::GetIO();
    if ((parts.panelKeys || KeysOwner::popup()) && !parts.dropDown.open()) {
        io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    } else {
        io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
    }
}

} // namespace

PanelUse drawSidePanel(EditParts& parts, CommandSet const& commands) {
    PanelUse use;
    passKeyboard(parts);
    Layout& layout = parts.context.layout;
    float const screen = ImGui::GetIO().DisplaySize.y;
    layout.beginCard("panel", "",
                     {.anchor = Anchor::TopRight, .offset = {editGap, topBar + 4}, .width = sidePanelWidth});
    drawTabs(parts, commands);
    ImGui::PushFont(theme().fonts.heading);
    ImGui::TextUnformatted(titleOf(parts.tab));
    ImGui::PopFont();
    float const used = ImGui::GetCursorPosY() + ImGui::GetStyle().WindowPadding.y;
    // In a narrow window the line with the grid reaches below the panel.
    bool const narrow = ImGui::GetIO().DisplaySize.x < scaled(statusWidth + sidePanelWidth + 3 * editGap);
    float const below = narrow ? statusRow + 2 * editGap : editGap;
    float const room = std::max(screen - scaled(topBar + 4 + below) - used, scaled(80));
    ImGui::PushStyleColor(ImGuiCol_ChildBg, ImVec4(0, 0, 0, 0));
    if (parts.panelKeys && parts.panelHadKeys != parts.tab) { // also another page takes the ring
        ImGui::SetNextWindowFocus();
    }
    parts.panelHadKeys = parts.panelKeys ? std::optional(parts.tab) : std::nullopt;
    ImGui::PushID(static_cast<int>(parts.tab));
    ImGui::BeginChild("page", {0, room});
    switch (parts.tab) {
    case Tab::parts:
        use.tookPart = drawPartsPage(parts);
        break;
    case Tab::outline:
        drawOutlinePage(parts);
        break;
    case Tab::properties:
        drawPropertiesPage(parts);
        break;
    case Tab::goals:
        drawGoalsPage(parts);
        break;
    case Tab::level:
        drawLevelPage(parts);
        break;
    case Tab::solutions:
        drawSolutionsPage(parts);
        break;
    case Tab::report:
        drawReportPage(parts);
        break;
    case Tab::search:
        drawSearchPage(parts);
        break;
    case Tab::problems:
        drawProblemsPage(parts);
        break;
    }
    ImGui::EndChild();
    ImGui::PopID();
    ImGui::PopStyleColor();
    layout.endCard();
    return use;
}

} // namespace trembler::ui
