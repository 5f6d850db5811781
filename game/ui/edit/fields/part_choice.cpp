#include "game/ui/edit/fields/part_choice.hpp"

#include "render/draw/palette.hpp"
#include "render/panels/theme.hpp"

namespace trembler::ui {

bool partChoice(EditParts& parts, std::string const& item, std::string& chosen,
                std::vector<std::string> const& names, char const* none) {
    PartCatalog const& catalog = parts.catalog();
    auto const shown = [&](std::string const& part) {
        return part.empty() ? std::string(none) : catalog.titleOf(part);
    };
    auto const entries = [&] {
        std::vector<DropDown::Entry> all;
        for (std::string const& name : names) {
            all.push_back({shown(name), " = " + name, catalog.textOf(name), name});
        }
        return all;
    };
    auto const now = parts.dropDown.draw(parts, item, shown(chosen), entries,
                                         [&](auto const& entry) { return entry.part == chosen; });
    if (!now || names[*now] == chosen) {
        return false;
    }
    chosen = names[*now];
    return true;
}

void partRow(EditParts& parts, std::string const& part, std::function<void()> const& draw) {
    using namespace render;
    ImVec2 const at = ImGui::GetCursorScreenPos();
    float const side = ImGui::GetTextLineHeight() + ImGui::GetStyle().ItemSpacing.y + ImGui::GetFrameHeight();
    float const indent = side + scaled(6);
    drawPartPicture(parts, part, at, side);
    ImGui::Indent(indent);
    ImGui::PushStyleColor(ImGuiCol_Text, imColour4(palette::inkSoft));
    ImGui::PushTextWrapPos(0); // up to the window's edge
    ImGui::TextUnformatted(parts.catalog().titleOf(part).c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    if (std::string const text = parts.catalog().textOf(part); !text.empty() && ImGui::IsItemHovered()) {
        tipBeside(text);
    }
    draw();
    ImGui::Unindent(indent);
}

} // namespace trembler::ui
