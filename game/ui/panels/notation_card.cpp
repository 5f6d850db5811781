#include "game/ui/panels/notation_card.hpp"

#include "game/ui/shared/texts.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>

namespace trembler::ui {

using namespace render;

namespace {

/// A row's text in the player's language; of a set in it, "{Position, Shape}", each name.
std::string shownRow(std::string const& text) {
    std::size_t const begin = text.find('{');
    std::size_t const end = text.find('}', begin);
    if (begin == std::string::npos || end == std::string::npos) {
        return translated(text);
    }
    std::string shown = translated(text.substr(0, begin)) + "{";
    for (std::size_t at = begin + 1; at < end;) {
        std::size_t const next = std::min(text.find(", ", at), end);
        shown += (at == begin + 1 ? "" : ", ") + translated(text.substr(at, next - at));
        at = next + 2;
    }
    return shown + "}" + translated(text.substr(end + 1));
}

} // namespace

void drawNotationBox(NotationBox const& box) {
    float const padding = scaled(9);
    ImVec2 const at = ImGui::GetCursorScreenPos();
    float const width = ImGui::GetContentRegionAvail().x;
    auto& list = *ImGui::GetWindowDrawList();
    list.ChannelsSplit(2); // the ground is drawn last, when the height is known, below the words
    list.ChannelsSetCurrent(1);
    ImGui::SetCursorScreenPos({at.x + padding, at.y + scaled(6)});
    ImGui::BeginGroup();
    ImGui::PushFont(theme().fonts.strong);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width - 2 * padding);
    ImGui::TextUnformatted(translated(box.title).c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
    float const line = ImGui::GetCursorScreenPos().y;
    ImGui::Dummy({0, scaled(3)});
    ImGui::PushFont(theme().fonts.small);
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(scaled(2), scaled(1)));
    if (ImGui::BeginTable("notation", 2, ImGuiTableFlags_SizingStretchProp, {width - 2 * padding, 0})) {
        ImGui::TableSetupColumn("label", ImGuiTableColumnFlags_WidthStretch, 0.27F);
        ImGui::TableSetupColumn("text", ImGuiTableColumnFlags_WidthStretch, 0.73F);
        for (NotationRow const& row : box.rows) {
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            ImGui::PushStyleColor(ImGuiCol_Text, imColour4(palette::inkSoft));
            ImGui::TextWrapped("%s", translated(row.label).c_str());
            ImGui::PopStyleColor();
            ImGui::TableNextColumn();
            ImGui::TextWrapped("%s", shownRow(row.text).c_str());
        }
        ImGui::EndTable();
    }
    ImGui::PopStyleVar();
    ImGui::PopFont();
    ImGui::EndGroup();
    float const bottom = ImGui::GetItemRectMax().y + scaled(6);
    list.ChannelsSetCurrent(0);
    ImU32 const ink = imColour(mix(palette::paperShade, palette::ink, 0.45F));
    list.AddRectFilled(at, {at.x + width, bottom}, imColour(palette::paperLight), scaled(4));
    list.AddRect(at, {at.x + width, bottom}, ink, scaled(4), 0, scaled(1.2F));
    list.AddLine({at.x, line}, {at.x + width, line}, ink, scaled(1.2F));
    list.ChannelsMerge();
    ImGui::SetCursorScreenPos(at);
    ImGui::Dummy({width, bottom - at.y});
}

} // namespace trembler::ui
