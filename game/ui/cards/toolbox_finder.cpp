#include "game/ui/cards/toolbox_finder.hpp"

#include "game/ui/shared/texts.hpp"
#include "game/ui/shared/words.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/cards.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <string>
#include <utility>

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

/// `beside`: what stands at its right, pixels.
void drawField(CommandButtons& buttons, ToolboxView& view, bool escape, float beside) {
    std::array<char, ToolboxView::longestText + 1> buffer{};
    std::memcpy(buffer.data(), view.sought().data(), view.sought().size());
    std::string const hint = words::seekPart(buttons.keyOf("find-part"));
    if (view.takeKeysAsked()) {
        ImGui::SetKeyboardFocusHere();
    }
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - beside);
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

Colour bodyOf(bool on) {
    return on                       ? palette::accent
           : ImGui::IsItemHovered() ? mix(palette::paperShade, palette::accent, 0.22F)
                                    : palette::paperShade;
}

/// A small button of a group; returns whether it was pressed.
bool groupButton(char const* id, Icon icon, ImVec2 size, bool on) {
    bool const pressed = ImGui::InvisibleButton(id, size);
    ImVec2 const low = ImGui::GetItemRectMin();
    ImVec2 const high = ImGui::GetItemRectMax();
    auto& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, imColour(bodyOf(on)), scaled(7));
    drawIcon(list, icon, {0.5F * (low.x + high.x), 0.5F * (low.y + high.y)}, scaled(15),
             imColour(on ? palette::paperLight : palette::ink));
    return pressed;
}

/// A line of text, in smaller letters if it is wider than `width`.
void fittedText(ImFont* font, ImVec2 at, float width, Colour colour, std::string const& text) {
    float const whole = font->CalcTextSizeA(font->FontSize, 1e9F, 0, text.c_str()).x;
    float const size = font->FontSize * std::min(1.F, width / std::max(whole, 1.F));
    ImGui::GetWindowDrawList()->AddText(font, size, {at.x, at.y + 0.5F * (font->FontSize - size)},
                                        imColour(colour), text.c_str());
}

/// Calls `each` with the id, the name and the icon of all parts and of every group that is there.
template <class Each>
void forGroups(std::vector<ToolboxSlot> const& slots, PartCatalog& catalog, Each const& each) {
    each("all", words::allParts, Icon::Grid, std::optional<PartGroup>());
    for (PartGroup const group : ToolboxView::groupsIn(slots, catalog)) {
        auto const index = static_cast<std::size_t>(group);
        each(std::string(partGroupNames[index]).c_str(), nameOf(group), groupLooks[index].icon,
             std::optional(group));
    }
}

std::string nameOfShown(ToolboxView const& view) {
    return view.group() ? nameOf(*view.group()) : words::allParts;
}

/// One line: the field and the button for the groups.
void drawBrief(CommandButtons& buttons, ToolboxView& view, bool escape) {
    float const side = ImGui::GetFrameHeight();
    float const gap = scaled(6);
    drawField(buttons, view, escape, side + gap);
    ImGui::SameLine(0, gap);
    Icon const icon = view.group() ? groupLooks[static_cast<std::size_t>(*view.group())].icon : Icon::Grid;
    if (groupButton("groups", icon, {side, side}, view.offersGroups() || view.group())) {
        view.offerGroups(!view.offersGroups());
    }
    buttons.layout().item("groups");
    if (ImGui::IsItemHovered() && !view.offersGroups()) { // then their names are there
        ImGui::SetNextWindowPos({ImGui::GetWindowPos().x - scaled(10), ImGui::GetItemRectMin().y},
                                ImGuiCond_Always, {1, 0});
        ImGui::SetTooltip("%s", nameOfShown(view).c_str());
    }
}

} // namespace

char const* nameOf(PartGroup group) {
    return text(groupLooks[static_cast<std::size_t>(group)].name);
}

void drawToolboxFinder(CommandButtons& buttons, std::vector<ToolboxSlot> const& slots, PartCatalog& catalog,
                       ToolboxView& view, bool escape, bool brief) {
    if (brief) {
        return drawBrief(buttons, view, escape);
    }
    ImFont* const font = theme().fonts.strong;
    ImVec2 const heading = ImGui::GetCursorScreenPos();
    float const width = ImGui::GetContentRegionAvail().x;
    ImGui::Dummy({width, font->FontSize});
    drawField(buttons, view, escape, 0);
    auto const places = static_cast<float>(ToolboxView::groupsIn(slots, catalog).size() + 1);
    float const gap = scaled(4);
    float const side = std::min(scaled(36), (width - (places - 1) * gap) / places);
    char const* pointed = nullptr;
    bool first = true;
    forGroups(slots, catalog,
              [&](char const* id, char const* name, Icon icon, std::optional<PartGroup> group) {
                  if (!std::exchange(first, false)) {
                      ImGui::SameLine(0, gap);
                  }
                  if (groupButton(id, icon, {side, scaled(28)}, view.group() == group)) {
                      view.choose(group);
                  }
                  pointed = ImGui::IsItemHovered() ? name : pointed;
                  buttons.layout().item(std::string("group ") + id);
              });
    // The name of the group under the pointer, else of the one that is shown, and how many parts it has.
    std::string const name = pointed != nullptr ? pointed
                                                : nameOfShown(view) + " (" +
                                                      std::to_string(view.shown(slots, catalog).size()) + ")";
    fittedText(font, heading, width, palette::ink, name);
}

void drawGroupList(Layout& layout, std::vector<ToolboxSlot> const& slots, PartCatalog& catalog,
                   ToolboxView& view) {
    ImVec2 const size{ImGui::GetContentRegionAvail().x, scaled(28)};
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, scaled(4)));
    forGroups(slots, catalog,
              [&](char const* id, char const* name, Icon icon, std::optional<PartGroup> group) {
                  bool const on = view.group() == group;
                  if (ImGui::InvisibleButton(id, size)) {
                      view.choose(group);
                  }
                  layout.item(std::string("group ") + id);
                  ImVec2 const low = ImGui::GetItemRectMin();
                  ImVec2 const high = ImGui::GetItemRectMax();
                  Colour const ink = on ? palette::paperLight : palette::ink;
                  ImFont* const font = theme().fonts.small;
                  auto& list = *ImGui::GetWindowDrawList();
                  list.AddRectFilled(low, high, imColour(bodyOf(on)), scaled(7));
                  float const middle = 0.5F * (low.y + high.y);
                  drawIcon(list, icon, {low.x + scaled(15), middle}, scaled(15), imColour(ink));
                  fittedText(font, {low.x + scaled(29), middle - 0.5F * font->FontSize},
                             high.x - low.x - scaled(35), ink, name);
              });
    ImGui::PopStyleVar();
}

} // namespace trembler::ui
