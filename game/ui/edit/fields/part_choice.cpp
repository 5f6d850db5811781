#include "game/ui/edit/fields/part_choice.hpp"

#include "game/ui/edit/fields/field_widgets.hpp"
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

void partFieldName(EditParts& parts, std::string const& part) {
    float const side = ImGui::GetFrameHeight();
    drawPartPicture(parts, part, ImGui::GetCursorScreenPos(), side);
    fieldName(parts.catalog().titleOf(part), parts.catalog().textOf(part), side + render::scaled(5));
}

} // namespace trembler::ui
