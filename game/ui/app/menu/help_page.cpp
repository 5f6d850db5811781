#include "game/ui/app/menu/help_page.hpp"

#include "game/ui/shared/texts.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/buttons.hpp"
#include "render/panels/theme.hpp"

namespace trembler::ui {
namespace {

using namespace render;

constexpr float roomForAll = 1300; // height at which no row needs scrolling, in pixels at UI scale 1

void drawHelpLine(HelpLine const& line) {
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, imColour4(palette::accent));
    ImGui::TextWrapped("%s", line.keys.c_str());
    ImGui::PopStyleColor();
    ImGui::TableNextColumn();
    ImGui::TextWrapped("%s", line.does.c_str());
}

void drawHelpLines(std::vector<HelpLine> const& lines) {
    ImGui::PushFont(theme().fonts.small);
    if (ImGui::BeginTable("keys", 4, ImGuiTableFlags_SizingStretchProp)) {
        for (char const* column : {"a", "b", "c", "d"}) {
            ImGui::TableSetupColumn(column, ImGuiTableColumnFlags_WidthStretch,
                                    *column % 2 == 1 ? 0.20F : 0.30F);
        }
        std::size_t const half = (lines.size() + 1) / 2;
        for (std::size_t row = 0; row < half; ++row) {
            ImGui::TableNextRow();
            drawHelpLine(lines[row]);
            if (row + half < lines.size()) {
                drawHelpLine(lines[row + half]);
            }
        }
        ImGui::EndTable();
    }
    ImGui::PopFont();
}

/// The rows are no buttons, so the focus never visits them: without a mouse arrows scroll them.
void scrollByKeys(MenuKeys const& keys) {
    float const step = scaled(60);
    if (keys.pressed(MenuKey::down, true)) {
        ImGui::SetScrollY(ImGui::GetScrollY() + step);
    } else if (keys.pressed(MenuKey::up, true)) {
        ImGui::SetScrollY(ImGui::GetScrollY() - step);
    }
}

} // namespace

HelpChoice drawHelp(UiContext& context, Screen& behind) {
    Layout& layout = context.layout;
    HelpChoice choice = HelpChoice::stay;
    layout.beginCard("help", text("keys.title"), {.anchor = Anchor::Middle, .width = 640});
    // With large letters on a small window the rows scroll.
    float const screen = ImGui::GetIO().DisplaySize.y / theme().scale;
    bool const scrolls = screen < roomForAll;
    if (scrolls) {
        ImGui::PushStyleColor(ImGuiCol_ChildBg, ImVec4(0, 0, 0, 0));
        ImGui::BeginChild("rows", {0, scaled(screen - 170)});
    }
    drawHelpLines(helpLines(behind.commands(), behind.gestures(), context.keys));
    if (scrolls) {
        scrollByKeys(context.menuKeys);
        ImGui::EndChild();
        ImGui::PopStyleColor();
    }
    ImGui::Dummy({0, scaled(4)});
    float const half = (ImGui::GetContentRegionAvail().x - scaled(8)) / 2 / theme().scale;
    bool change = bigButton(text("keys.change"), {.icon = Icon::Settings, .width = half});
    layout.item("change keys");
    change = context.focus.item() || change;
    ImGui::SameLine(0, scaled(8));
    bool back = bigButton(text("menu.back"), {.icon = Icon::Back, .width = half});
    layout.item("close help");
    back = context.focus.item() || back;
    layout.endCard();
    if (change) {
        choice = HelpChoice::changeKeys;
    } else if (back) {
        choice = HelpChoice::back;
    }
    return choice;
}

} // namespace trembler::ui
