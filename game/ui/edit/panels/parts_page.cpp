#include "game/ui/edit/commands/edit_actions.hpp"
#include "game/ui/edit/edit_words.hpp"
#include "game/ui/edit/fields/drop_down.hpp"
#include "game/ui/edit/fields/field_widgets.hpp"
#include "game/ui/edit/panels/side_panel.hpp"
#include "game/ui/shared/words.hpp"
#include "render/panels/cards.hpp"
#include "render/panels/theme.hpp"
#include "render/panels/toolbox_tile.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::ui {
namespace {

using namespace render;

constexpr float tileOfCatalogue = 80;

void tipOfPart(EditParts& parts, std::string const& part) {
    placeTipBeside(); // the tiles below stay in sight
    ImGui::BeginTooltip();
    ImGui::PushFont(theme().fonts.strong);
    ImGui::TextUnformatted(parts.catalog().titleOf(part).c_str());
    ImGui::PopFont();
    if (std::string const text = parts.catalog().textOf(part); !text.empty()) {
        ImGui::TextUnformatted(words::wrapped(text, 44).c_str());
    }
    ImGui::EndTooltip();
}

} // namespace

bool drawPartsPage(EditParts& parts) {
    bool took = false;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    textField("##search", parts.searched, 60);
    parts.context.layout.item("search parts");
    if (parts.searched.empty()) {
        ImVec2 const at = ImGui::GetItemRectMin();
        ImVec2 const padding = ImGui::GetStyle().FramePadding;
        ImGui::GetWindowDrawList()->AddText({at.x + padding.x, at.y + padding.y},
                                            ImGui::GetColorU32(ImGuiCol_TextDisabled), words::search);
    }
    float const gap = scaled(6);
    int const columns = std::max(
        1, static_cast<int>((ImGui::GetContentRegionAvail().x + gap) / (scaled(tileOfCatalogue) + gap)));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(gap, gap));
    int shown = 0;
    for (std::string const& part : parts.data->parts.names()) {
        std::string const title = parts.catalog().titleOf(part);
        if (!fitsSearch(title + " " + part + " " + parts.catalog().textOf(part), parts.searched)) {
            continue;
        }
        if (shown++ % columns != 0) {
            ImGui::SameLine();
        }
        auto const pixels = static_cast<int>(std::lround(scaled(tileOfCatalogue - 12)));
        // Only visible rows get a picture: there may be hundreds of parts.
        bool const seen = ImGui::IsRectVisible({scaled(tileOfCatalogue), scaled(tileOfCatalogue + 24)});
        TileUse const use = toolboxTile({.id = part.c_str(),
                                         .name = title.c_str(),
                                         .picture = seen ? parts.catalog().picture(part, pixels) : 0,
                                         .selected = parts.partInHand == part,
                                         .side = tileOfCatalogue});
        parts.context.layout.item("part " + part);
        bool const byKey =
            parts.panelKeys && ImGui::IsItemFocused() && parts.context.menuKeys.pressed(MenuKey::press);
        if (byKey) {
            actions::addPart(parts, part, parts.middleOfView());
        } else if (use.taken && !parts.document.readOnly() &&
                   parts.context.input.pressed(MouseButton::Left)) {
            parts.partInHand = parts.partInHand == part ? std::string() : part;
            parts.tool = Tool::select;
            took = true;
        }
        if (use.hovered && parts.partInHand.empty()) {
            tipOfPart(parts, part);
        }
    }
    ImGui::PopStyleVar();
    if (shown == 0) {
        caption(words::nothingFound);
    }
    return took;
}

} // namespace trembler::ui
