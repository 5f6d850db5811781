#include "game/ui/cards/play_cards.hpp"
#include "game/ui/shared/commands/asked_twice.hpp"
#include "game/ui/shared/words.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/theme.hpp"
#include "render/panels/toolbox_tile.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::ui {
namespace {

using namespace render;

constexpr float tileSide = 92;
constexpr float handRowHeight = 52;

/// Shows the part's description while the mouse rests on its tile: left of the toolbox, whose other tiles
/// stay in sight.
void tipFor(PartCatalog const& catalog, std::string const& part) {
    float const top = std::min(ImGui::GetItemRectMin().y, ImGui::GetIO().DisplaySize.y - scaled(160));
    ImGui::SetNextWindowPos({ImGui::GetWindowPos().x - scaled(10), std::max(top, 0.F)}, ImGuiCond_Always,
                            {1, 0});
    ImGui::BeginTooltip();
    ImGui::PushFont(theme().fonts.strong);
    ImGui::TextUnformatted(catalog.titleOf(part).c_str());
    ImGui::PopFont();
    if (std::string const text = catalog.textOf(part); !text.empty()) {
        ImGui::TextUnformatted(words::wrapped(text, 44).c_str());
    }
    ImGui::EndTooltip();
}

void drawWhereToDrop() {
    ImVec2 const low = ImGui::GetWindowPos();
    ImVec2 const size = ImGui::GetWindowSize();
    auto& list = *ImGui::GetForegroundDrawList();
    ImVec2 const high{low.x + size.x, low.y + size.y};
    list.AddRect(low, high, imColour(palette::accent), scaled(12), 0, scaled(3));
}

/// The keys for the part in the hand, if there is room for them.
void drawHandRow(CommandButtons& buttons) {
    constexpr float sides = 4 * 40;
    float const room = ImGui::GetContentRegionAvail().x / theme().scale;
    float const between = std::clamp((room - sides) / 3, 2.F, 6.F);
    float const width = scaled(sides + 3 * between);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 0.5F * (ImGui::GetContentRegionAvail().x - width));
    bool first = true;
    for (char const* const id : {"turn-left", "turn-right", "flip", "put-back"}) {
        if (!first) {
            ImGui::SameLine(0, scaled(between));
        }
        first = false;
        buttons.icon(id);
    }
}

/// The button that puts all parts back; pressed once, it asks.
void drawAllBack(CommandButtons& buttons, AskedTwice const& allBack) {
    bool const asks = allBack.waiting();
    buttons.big("all-back", {.label = asks ? words::allBackAsk : nullptr,
                             .look = asks ? ButtonLook::Danger : ButtonLook::Quiet,
                             .width = -1,
                             .withIcon = !asks});
}

} // namespace

std::optional<std::string> drawToolbox(CommandButtons& buttons, Session const& session, PartCatalog& catalog,
                                       std::optional<CarriedPart> const& carried, std::string const& hint,
                                       AskedTwice const& allBack, bool laying) {
    Layout& layout = buttons.layout();
    std::optional<std::string> taken;
    auto const slots = session.toolbox();
    int const wires = session.level().wires;
    if (slots.empty() && wires == 0) {
        return taken;
    }
    layout.beginCard("toolbox", words::toolbox,
                     {.anchor = Anchor::TopRight,
                      .offset = {cardGap, cornerRow},
                      .width = toolboxWidth(ImGui::GetIO().DisplaySize.x / theme().scale)});
    float const screen = ImGui::GetIO().DisplaySize.y;
    float const gap = scaled(8);
    float const tile = scaled(tileSide + 24);
    auto const rows = static_cast<float>((slots.size() + 1) / 2);
    float const wanted = rows * (tile + gap);
    float const without = screen - scaled(cornerRow + bottomRow + 200 + (wires > 0 ? 56 : 0));
    bool const handRow = !slots.empty() && without > tile + scaled(handRowHeight);
    float const room = without - (handRow ? scaled(handRowHeight) : 0);
    bool const scrolls = wanted > room;
    if (scrolls) {
        ImGui::PushStyleColor(ImGuiCol_ChildBg, ImVec4(0, 0, 0, 0));
        ImGui::BeginChild("tiles", {0, room});
    }
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(gap, gap));
    // Two columns, centred in the card; a scroll bar takes some of their width.
    float const width = ImGui::GetContentRegionAvail().x;
    float const side = std::min(tileSide, 0.5F * (width - gap) / theme().scale);
    float const left = ImGui::GetCursorPosX() + 0.5F * (width - (2 * scaled(side) + gap));
    for (std::size_t i = 0; i < slots.size(); ++i) {
        if (i % 2 == 1) {
            ImGui::SameLine();
        } else {
            ImGui::SetCursorPosX(left);
        }
        ToolboxSlot const& slot = slots[i];
        bool const inHand = carried && carried->part == slot.part;
        std::string const title = catalog.titleOf(slot.part);
        int const rest = slot.left - (inHand && carried->isNew ? 1 : 0); // that one is in the hand
        auto const pixels = static_cast<int>(std::lround(scaled(side - 12)));
        TileUse const use = toolboxTile({.id = slot.part.c_str(),
                                         .name = title.c_str(),
                                         .count = rest,
                                         .picture = catalog.picture(slot.part, pixels),
                                         .selected = inHand,
                                         .side = side});
        layout.item("part " + slot.part);
        if (use.taken) {
            taken = slot.part;
        }
        if (use.hovered && !carried) {
            tipFor(catalog, slot.part);
        }
    }
    ImGui::PopStyleVar();
    if (scrolls) {
        ImGui::EndChild();
        ImGui::PopStyleColor();
    }
    if (handRow) {
        drawHandRow(buttons);
    }
    if (wires > 0) {
        std::string const label = words::wiresLeft(session.wiresLeft());
        buttons.big(
            "wire",
            {.label = label.c_str(), .look = laying ? ButtonLook::Primary : ButtonLook::Quiet, .width = -1});
    }
    smallCaption(carried ? words::dropHere : hint.c_str());
    drawAllBack(buttons, allBack);
    if (carried) {
        drawWhereToDrop();
    }
    layout.endCard();
    return taken;
}

} // namespace trembler::ui
