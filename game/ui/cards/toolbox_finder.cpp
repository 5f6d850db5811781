#include "game/ui/cards/toolbox_finder.hpp"

#include "game/ui/shared/texts.hpp"
#include "game/ui/shared/words.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/cards.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <string>

namespace trembler::ui {
namespace {

using namespace render;

struct GroupLook {
    char const* name; ///< the id of a text
    Icon icon;
};

/// In the order of PartGroup.
constexpr std::array<GroupLook, partGroupNames.size()> groupLooks{GroupLook{"group.electricity", Icon::Bolt},
                                                                  {"group.magnets", Icon::Magnet},
                                                                  {"group.mechanics", Icon::Settings},
                                                                  {"group.water", Icon::Drop},
                                                                  {"group.sound", Icon::Note},
                                                                  {"group.structures", Icon::Wall},
                                                                  {"group.solids", Icon::Solids},
                                                                  {"group.mods", Icon::Script}};

void drawField(CommandButtons& buttons, ToolboxView& view, bool escape) {
    std::array<char, ToolboxView::longestText + 1> buffer{};
    std::memcpy(buffer.data(), view.sought().data(), view.sought().size());
    std::string const hint = words::seekPart(buttons.keyOf("find-part"));
    if (view.takeKeysAsked()) {
        ImGui::SetKeyboardFocusHere();
    }
    ImGui::SetNextItemWidth(-1);
    bool const taken =
        ImGui::InputTextWithHint("##seek", hint.c_str(), buffer.data(), buffer.size(),
                                 ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    bool const left = ImGui::IsItemDeactivated() && escape;
    buttons.layout().item("seek part");
    if (left) {
        view.seek("");
    } else if (view.sought() != buffer.data()) {
        view.seek(buffer.data());
    }
    if (taken) {
        view.want();
    }
}

/// A small button of a group; returns whether it was pressed.
bool groupButton(char const* id, Icon icon, float side, bool on) {
    bool const pressed = ImGui::InvisibleButton(id, {side, scaled(28)});
    bool const hovered = ImGui::IsItemHovered();
    ImVec2 const low = ImGui::GetItemRectMin();
    ImVec2 const high = ImGui::GetItemRectMax();
    auto& list = *ImGui::GetWindowDrawList();
    Colour const body = on        ? palette::accent
                        : hovered ? mix(palette::paperShade, palette::accent, 0.22F)
                                  : palette::paperShade;
    list.AddRectFilled(low, high, imColour(body), scaled(7));
    drawIcon(list, icon, {0.5F * (low.x + high.x), 0.5F * (low.y + high.y)}, scaled(15),
             imColour(on ? palette::paperLight : palette::ink));
    return pressed;
}

} // namespace

char const* nameOf(PartGroup group) {
    return text(groupLooks[static_cast<std::size_t>(group)].name);
}

void drawToolboxFinder(CommandButtons& buttons, std::vector<ToolboxSlot> const& slots, PartCatalog& catalog,
                       ToolboxView& view, bool escape) {
    drawField(buttons, view, escape);
    auto const there = ToolboxView::groupsIn(slots, catalog);
    auto const places = static_cast<float>(there.size() + 1);
    float const gap = scaled(4);
    float const side = std::min(scaled(36), (ImGui::GetContentRegionAvail().x - (places - 1) * gap) / places);
    char const* pointed = nullptr;
    auto const choose = [&](char const* id, char const* name, Icon icon, std::optional<PartGroup> group) {
        if (groupButton(id, icon, side, view.group() == group)) {
            view.choose(group);
        }
        pointed = ImGui::IsItemHovered() ? name : pointed;
        buttons.layout().item(std::string("group ") + id);
    };
    choose("all", words::allParts, Icon::Grid, {});
    for (PartGroup const group : there) {
        ImGui::SameLine(0, gap);
        auto const index = static_cast<std::size_t>(group);
        choose(std::string(partGroupNames[index]).c_str(), nameOf(group), groupLooks[index].icon, group);
    }
    // The name of the group under the pointer, else of the one that is shown, and how many parts it has.
    std::string name = pointed != nullptr ? pointed : view.group() ? nameOf(*view.group()) : words::allParts;
    if (pointed == nullptr) {
        name += " (" + std::to_string(view.shown(slots, catalog).size()) + ")";
    }
    smallCaption(name.c_str());
}

} // namespace trembler::ui
