#include "game/ui/edit/panels/bars.hpp"

#include "game/ui/edit/commands/command_menus.hpp"
#include "game/ui/edit/edit_words.hpp"
#include "game/ui/edit/fields/field_widgets.hpp"
#include "game/ui/edit/panels/tool_icons.hpp"
#include "game/ui/shared/commands/command_buttons.hpp"
#include "game/ui/shared/commands/named_keys.hpp"
#include "game/ui/shared/texts.hpp"
#include "physics/dynamics/properties/joint.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/check_box.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace trembler::ui {
namespace {

using namespace render;

struct ToolRow {
    Tool tool;
    char const* id;
};
constexpr std::array<ToolRow, 9> toolRows{{{Tool::select, "edit-select"},
                                           {Tool::box, "edit-box"},
                                           {Tool::disc, "edit-disc"},
                                           {Tool::capsule, "edit-capsule"},
                                           {Tool::polygon, "edit-polygon"},
                                           {Tool::joint, "edit-joint"},
                                           {Tool::wire, "edit-wire"},
                                           {Tool::placing, "edit-placing"},
                                           {Tool::goalArea, "edit-goal-area"}}};

/// "Undo: Move 3 objects" for the two commands whose effect the history names.
std::string menuLabel(EditParts const& parts, CommandInfo const& info) {
    std::string label = info.name;
    std::string const step = info.id == "edit-undo"   ? parts.document.undoName()
                             : info.id == "edit-redo" ? parts.document.redoName()
                                                      : std::string();
    return step.empty() ? label : label + ": " + translated(step);
}

void drawMenu(EditParts& parts, EditMenu const& menu, CommandSet const& commands,
              std::optional<std::size_t>& asked) {
    Layout& layout = parts.context.layout;
    std::string const popup = std::string("menu ") + menu.title;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(scaled(9), scaled(10)));
    if (ImGui::Button(menu.title)) {
        ImGui::OpenPopup(popup.c_str());
    }
    layout.item(popup);
    ImGui::PopStyleVar();
    ImVec2 const below{ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y + scaled(4)};
    ImGui::SetNextWindowPos(below);
    float const most = ImGui::GetIO().DisplaySize.y - below.y - scaled(12);
    ImGui::SetNextWindowSizeConstraints({scaled(230), 0}, {scaled(420), most});
    if (!ImGui::BeginPopup(popup.c_str())) {
        return;
    }
    for (Command<EditParts> const& command : menu.commands()) {
        std::size_t const index = commands.indexOf(command.info.id);
        auto const keys = parts.context.keys.keysOf(command.info.id);
        std::string const key = keys.empty() ? std::string() : labelOf(keys.front());
        std::string const label = menuLabel(parts, command.info) + "##" + std::string(command.info.id);
        if (ImGui::MenuItem(label.c_str(), key.c_str(), commands.on(index), commands.available(index))) {
            asked = index;
        }
        layout.item("item " + std::string(command.info.id));
        if (ImGui::IsItemHovered()) {
            tipBeside(shownTip(command.info, false, parts.context.keys));
        }
    }
    ImGui::EndPopup();
}

void drawTop(EditParts& parts, CommandSet const& commands, std::optional<std::size_t>& asked) {
    Layout& layout = parts.context.layout;
    layout.beginCard("bar", "", {.anchor = Anchor::TopLeft, .offset = {editGap, editGap}, .bare = true});
    for (EditMenu const& menu : editMenus) {
        drawMenu(parts, menu, commands, asked);
        ImGui::SameLine(0, scaled(4));
    }
    CommandButtons buttons(layout, parts.context.keys, commands);
    for (char const* id : {"edit-undo", "edit-redo", "edit-save"}) {
        buttons.icon(id);
        ImGui::SameLine(0, scaled(5));
    }
    buttons.big("edit-test", {.look = ButtonLook::Primary});
    if (buttons.asked()) {
        asked = buttons.asked();
    }
    layout.endCard();
}

void drawLevelName(EditParts& parts) {
    Layout& layout = parts.context.layout;
    // The menus are longer in some languages than in others.
    auto const bar = layout.card("bar");
    double const left = bar ? bar->high.x : scaled(560);
    float const room =
        (ImGui::GetIO().DisplaySize.x - static_cast<float>(left)) / theme().scale - 2 * editGap;
    if (room < 90) {
        return;
    }
    layout.beginCard("level name", "",
                     {.anchor = Anchor::TopRight,
                      .offset = {editGap, editGap},
                      .width = std::min(room, sidePanelWidth),
                      .bare = true});
    // A new level has the name of the file as which it was opened and will be saved.
    std::filesystem::path const& proposed = parts.dialogs.proposed();
    std::string name = parts.document.path().empty() && !proposed.empty() ? proposed.filename().string()
                                                                          : parts.document.name();
    std::size_t const slash = name.rfind('/');
    name = slash == std::string::npos ? name : name.substr(slash + 1);
    ImGui::PushFont(theme().fonts.strong);
    ImGui::TextWrapped("%s%s", name.c_str(), parts.document.modified() ? " *" : "");
    ImGui::PopFont();
    ImGui::PushFont(theme().fonts.small);
    char const* const state = parts.document.readOnly() ? words::readOnlyShort
                              : parts.document.modified() || parts.document.path().empty() ? words::notSaved
                                                                                           : words::allSaved;
    auto const& unsafe = parts.autosave->error();
    caption(unsafe ? words::notSafe : state);
    if (unsafe) {
        layout.item("not safe");
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s", notWritten(Owned::unsavedLevel, *unsafe).c_str());
        }
    }
    ImGui::PopFont();
    layout.endCard();
}

void drawToolColumn(EditParts& parts, CommandSet const& commands, std::optional<std::size_t>& asked) {
    Layout& layout = parts.context.layout;
    layout.beginCard("tools", "", {.anchor = Anchor::TopLeft, .offset = {editGap, topBar + 4}, .bare = true});
    float const room = ImGui::GetIO().DisplaySize.y / theme().scale - topBar - statusRow - 24;
    float const gap = 4;
    float const side = std::clamp(room / static_cast<float>(toolRows.size()) - gap, 24.F, 40.F);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(scaled(gap), scaled(gap)));
    CommandButtons const buttons(layout, parts.context.keys, commands);
    for (ToolRow const& row : toolRows) {
        if (toolButton(row.id, row.tool, buttons.tip(row.id).c_str(), parts.tool == row.tool, side)) {
            asked = commands.indexOf(row.id);
        }
        layout.item(row.id);
    }
    ImGui::PopStyleVar();
    layout.endCard();
}

void stepField(EditParts& parts, char const* name, char const* item, double& value, double low, double high,
               char const* unit) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(name);
    ImGui::SameLine(0, scaled(5));
    ImGui::SetNextItemWidth(scaled(74));
    static_cast<void>(numberField(parts, item, value, low, high, unit));
    ImGui::SameLine(0, scaled(10));
}

void drawStatus(EditParts& parts) {
    Layout& layout = parts.context.layout;
    layout.beginCard("status", "", {.anchor = Anchor::BottomLeft, .offset = {editGap, editGap}});
    Snapping& snapping = parts.snapping;
    render::checkBox("##snap", &snapping.on);
    layout.item("snap");
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("%s", withKey(words::snapTip, "edit-snap", parts.context.keys).c_str());
    }
    ImGui::SameLine(0, scaled(6));
    stepField(parts, words::gridStep, "grid step", snapping.grid, Snapping::smallestGrid,
              Snapping::largestGrid, "m");
    stepField(parts, words::angleStep, "angle step", snapping.angleDegrees, Snapping::smallestAngle,
              Snapping::largestAngle, "°");
    if (parts.tool == Tool::joint) {
        ImGui::SetNextItemWidth(scaled(110));
        std::vector<std::string> const forms{choiceNames<JointForm>.begin(), choiceNames<JointForm>.end()};
        static_cast<void>(choiceField(parts, "joint form", parts.jointForm, forms, shownChoice));
    } else if (parts.tool == Tool::capsule) {
        stepField(parts, words::radius, "capsule radius", parts.capsuleRadius, 0.005, 10, "m");
        ImGui::NewLine();
        ImGui::SameLine();
    } else {
        // Always of the same width, so that nothing moves while the mouse does.
        std::array<char, 64> place{};
        std::snprintf(place.data(), place.size(), "%8.2f %8.2f m", parts.pointer.world.x,
                      parts.pointer.world.y);
        ImGui::AlignTextToFramePadding();
        ImVec2 const at = ImGui::GetCursorScreenPos();
        ImGui::Dummy({scaled(140), ImGui::GetFrameHeight()});
        ImGui::GetWindowDrawList()->AddText({at.x, at.y + ImGui::GetStyle().FramePadding.y},
                                            imColour(palette::inkSoft), place.data());
    }
    layout.endCard();
}

} // namespace

std::optional<std::size_t> drawBars(EditParts& parts, CommandSet const& commands) {
    std::optional<std::size_t> asked;
    drawTop(parts, commands, asked);
    drawLevelName(parts);
    drawToolColumn(parts, commands, asked);
    drawStatus(parts);
    return asked;
}

} // namespace trembler::ui
