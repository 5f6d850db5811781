#include "game/ui/cards/play_cards.hpp"
#include "game/ui/cards/toolbox_finder.hpp"
#include "game/ui/cards/toolbox_view.hpp"
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
constexpr float tileFoot = 24;
constexpr float handRowHeight = 52;
constexpr float iconButtonHeight = 42;
constexpr float leastTileInLarge = 66; ///< a large toolbox has as many columns as fit
constexpr float leastPicture = 60;     ///< height of a picture in it: it has as many whole rows as fit
constexpr float tallWindow = 700;      ///< with room for rows of buttons around the tiles of a large toolbox

/// What a small toolbox has beside its tiles, pixels at UI scale 1: title, hint, the button that puts all
/// parts back.
constexpr float smallRest = 200;
constexpr float wireRow = 56;

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

/// In a low window: the buttons for wires and for putting all parts back.
void drawIconRow(CommandButtons& buttons, bool wires) {
    float const width = (wires ? 2 : 1) * scaled(40) + (wires ? scaled(7) : 0);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 0.5F * (ImGui::GetContentRegionAvail().x - width));
    if (wires) {
        buttons.icon("wire");
        ImGui::SameLine(0, scaled(7));
    }
    buttons.icon("all-back");
}

struct TileGrid {
    std::size_t columns = 2;
    float side = tileSide; ///< at most
    float gap = 8;
    float width = 0; ///< of a tile, if it is wider than high
};

/// The rows of buttons below the tiles.
struct RowsBelow {
    bool hand = false;
    bool wires = false;   ///< a large button for them
    bool allBack = false; ///< a large button for it
    bool icons = false;   ///< one row of small buttons instead

    /// With the gaps between them and the edge of the card, pixels.
    [[nodiscard]] float height() const {
        float const gap = ImGui::GetStyle().ItemSpacing.y;
        float const large = theme().fonts.strong->FontSize + scaled(24) + gap;
        float const small = scaled(iconButtonHeight) + gap;
        return ImGui::GetStyle().WindowPadding.y + (hand ? small : 0) + (wires ? large : 0) +
               (allBack ? large : 0) + (icons ? small : 0);
    }
};

/// The tiles of a large toolbox in a room of this height, pixels: whole rows of them.
TileGrid gridOfLarge(float room) {
    TileGrid grid;
    grid.gap = 6;
    float const width = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ScrollbarSize) / theme().scale;
    auto const columns = std::max(1.F, std::floor((width + grid.gap) / (leastTileInLarge + grid.gap)));
    grid.columns = static_cast<std::size_t>(columns);
    grid.width = std::min(tileSide, (width - (columns - 1) * grid.gap) / columns);
    float const high = room / theme().scale + grid.gap;
    float const rows = std::max(1.F, std::floor(high / (leastPicture + tileFoot + grid.gap)));
    grid.side = std::clamp(high / rows - grid.gap - tileFoot, std::min(leastPicture, grid.width), grid.width);
    return grid;
}

/// The tiles, in columns that are centred in the card. Returns the part that was taken.
std::optional<std::string> drawTiles(Layout& layout, std::vector<ToolboxSlot> const& shown,
                                     PartCatalog& catalog, std::optional<CarriedPart> const& carried,
                                     TileGrid const& grid, bool toHand) {
    std::optional<std::string> taken;
    float const gap = scaled(grid.gap);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(gap, gap));
    float const width = ImGui::GetContentRegionAvail().x; // a scroll bar takes some of it
    auto const columns = static_cast<float>(grid.columns);
    float const most = ((width - (columns - 1) * gap) / columns) / theme().scale;
    float const side = std::min(grid.side, most);
    float const wide = std::clamp(grid.width, side, std::max(side, most));
    float const left =
        ImGui::GetCursorPosX() + 0.5F * (width - (columns * scaled(wide) + (columns - 1) * gap));
    for (std::size_t i = 0; i < shown.size(); ++i) {
        if (i % grid.columns != 0) {
            ImGui::SameLine();
        } else {
            ImGui::SetCursorPosX(left);
        }
        ToolboxSlot const& slot = shown[i];
        bool const inHand = carried && carried->part == slot.part;
        bool const unlimited = slot.left == unlimitedCount;
        bool const inSight = ImGui::IsRectVisible({scaled(wide), scaled(side + tileFoot)});
        std::string const title = catalog.titleOf(slot.part);
        auto const pixels = static_cast<int>(std::lround(scaled(side - 12)));
        TileUse const use = toolboxTile(
            {.id = slot.part.c_str(),
             .name = title.c_str(),
             .count =
                 unlimited ? -1 : slot.left - (inHand && carried->isNew ? 1 : 0), // that one is in the hand
             .picture = inSight ? catalog.picture(slot.part, pixels) : 0,
             .selected = inHand,
             .side = side,
             .width = wide});
        if (inHand && toHand) {
            ImGui::SetScrollHereY();
        }
        if (inSight) {
            layout.item("part " + slot.part);
        }
        if (use.taken) {
            taken = slot.part;
        }
        if (use.hovered && !carried) {
            tipFor(catalog, slot.part);
        }
    }
    ImGui::PopStyleVar();
    return taken;
}

/// The tiles, which scroll if there are more than fit into `room` (pixels).
std::optional<std::string> drawScrolledTiles(Layout& layout, std::vector<ToolboxSlot> const& slots,
                                             PartCatalog& catalog, ToolboxView& view,
                                             std::optional<CarriedPart> const& carried, TileGrid const& grid,
                                             float room) {
    bool const large = ToolboxView::large(slots);
    std::vector<ToolboxSlot> const shown = view.shown(slots, catalog);
    auto const rows = static_cast<float>((shown.size() + grid.columns - 1) / grid.columns);
    // A large toolbox keeps its size, whatever is sought in it.
    bool const scrolls = large || rows * scaled(grid.side + tileFoot + grid.gap) > room;
    if (scrolls) {
        ImGui::PushStyleColor(ImGuiCol_ChildBg, ImVec4(0, 0, 0, 0));
        ImGui::BeginChild("tiles", {0, room});
    }
    if (large && shown.empty()) {
        caption(words::noSuchPart);
    }
    bool const toHand = view.newInHand(carried && carried->isNew ? carried->part : std::string());
    std::optional<std::string> taken = drawTiles(layout, shown, catalog, carried, grid, toHand);
    if (scrolls) {
        ImGui::EndChild();
        ImGui::PopStyleColor();
    }
    return taken;
}

void drawWireButton(CommandButtons& buttons, Session const& session, bool large, bool laying) {
    std::string const key = buttons.keyOf("wire");
    std::string const label =
        words::wiresLeft(session.wiresLeft()) + (large && !key.empty() ? " (" + key + ")" : "");
    buttons.big(
        "wire",
        {.label = label.c_str(), .look = laying ? ButtonLook::Primary : ButtonLook::Quiet, .width = -1});
}

/// In a low window there is one line above the tiles and one below.
std::optional<std::string> drawLarge(CommandButtons& buttons, Session const& session,
                                     std::vector<ToolboxSlot> const& slots, PartCatalog& catalog,
                                     ToolboxView& view, ToolboxLook const& look) {
    float const screen = ImGui::GetIO().DisplaySize.y;
    bool const low = screen < scaled(tallWindow);
    bool const wires = session.level().wires > 0;
    drawToolboxFinder(buttons, slots, catalog, view, look.escape, low);
    RowsBelow const below{.hand = !low, .wires = wires && !low, .allBack = !low, .icons = low};
    float const room = std::max(screen - scaled(bottomRow) - ImGui::GetCursorScreenPos().y - below.height(),
                                scaled(tileFoot));
    std::optional<std::string> taken;
    if (low && view.offersGroups()) {
        ImGui::PushStyleColor(ImGuiCol_ChildBg, ImVec4(0, 0, 0, 0));
        ImGui::BeginChild("groups", {0, room});
        drawGroupList(buttons.layout(), slots, catalog, view);
        ImGui::EndChild();
        ImGui::PopStyleColor();
    } else {
        taken =
            drawScrolledTiles(buttons.layout(), slots, catalog, view, look.carried, gridOfLarge(room), room);
    }
    if (low) {
        drawIconRow(buttons, wires);
        return taken;
    }
    drawHandRow(buttons);
    if (wires) {
        drawWireButton(buttons, session, true, look.laying);
    }
    drawAllBack(buttons, look.allBack);
    return taken;
}

std::optional<std::string> drawSmall(CommandButtons& buttons, Session const& session,
                                     std::vector<ToolboxSlot> const& slots, PartCatalog& catalog,
                                     ToolboxView& view, ToolboxLook const& look) {
    float const screen = ImGui::GetIO().DisplaySize.y;
    bool const wires = session.level().wires > 0;
    TileGrid const grid;
    float const tile = scaled(grid.side + tileFoot);
    float const without = screen - scaled(cornerRow + bottomRow + smallRest + (wires ? wireRow : 0));
    bool const handRow = !slots.empty() && without > tile + scaled(handRowHeight);
    float const room = without - (handRow ? scaled(handRowHeight) : 0);
    std::optional<std::string> const taken =
        drawScrolledTiles(buttons.layout(), slots, catalog, view, look.carried, grid, room);
    if (handRow) {
        drawHandRow(buttons);
    }
    if (wires) {
        drawWireButton(buttons, session, false, look.laying);
    }
    smallCaption(look.carried ? words::dropHere : look.hint.c_str());
    drawAllBack(buttons, look.allBack);
    return taken;
}

} // namespace

bool hasLargeToolbox(Session const& session) {
    return session.level().toolbox.size() > ToolboxView::mostInSmall;
}

std::optional<std::string> drawToolbox(CommandButtons& buttons, Session const& session, PartCatalog& catalog,
                                       ToolboxView& view, ToolboxLook const& look) {
    auto const slots = session.toolbox();
    if (slots.empty() && session.level().wires == 0) {
        return {};
    }
    bool const large = ToolboxView::large(slots);
    buttons.layout().beginCard(
        "toolbox", large ? "" : words::toolbox, // the name of the group that is shown is the heading
        {.anchor = Anchor::TopRight,
         .offset = {cardGap, cornerRow},
         .width = toolboxWidth(ImGui::GetIO().DisplaySize.x / theme().scale, hasLargeToolbox(session))});
    auto const draw = large ? drawLarge : drawSmall;
    std::optional<std::string> taken = draw(buttons, session, slots, catalog, view, look);
    if (look.carried) {
        drawWhereToDrop();
    }
    buttons.layout().endCard();
    return taken;
}

} // namespace trembler::ui
