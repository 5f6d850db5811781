#include "game/ui/cards/overlay_legend.hpp"

#include "game/ui/shared/card_sizes.hpp"
#include "game/ui/shared/texts.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/theme.hpp"
#include "render/scene/overlays/overlay_contacts.hpp"
#include "render/scene/overlays/overlay_magnetism.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>

namespace trembler::ui {
namespace {

using namespace render;

// Pixels at UI scale 1.
constexpr float signWidth = 92;
constexpr float rowHeight = 19;

enum class LegendSign { line, dashes, arrow, mark };

struct LegendRow {
    LegendSign sign;
    Colour colour;
    float length; ///< pixels at UI scale 1
    float width;
    char const* words;
};

void drawDashes(ImDrawList& list, ImVec2 from, float length, ImU32 colour, float width) {
    for (float at = 0; at < length; at += scaled(10)) {
        list.AddLine({from.x + at, from.y}, {from.x + std::min(at + scaled(6), length), from.y}, colour,
                     width);
    }
}

void drawSign(LegendRow const& row, ImVec2 from) {
    auto& list = *ImGui::GetWindowDrawList();
    ImU32 const colour = imColour(row.colour);
    float const length = scaled(row.length);
    float const width = scaled(row.width);
    ImVec2 const to{from.x + length, from.y};
    switch (row.sign) {
    case LegendSign::line:
        list.AddLine(from, to, colour, width);
        break;
    case LegendSign::dashes:
        drawDashes(list, from, length, colour, width);
        break;
    case LegendSign::arrow: {
        float const head = scaled(9);
        list.AddLine(from, {to.x - head, to.y}, colour, width);
        list.AddTriangleFilled({to.x, to.y}, {to.x - head, to.y - scaled(5)}, {to.x - head, to.y + scaled(5)},
                               colour);
        break;
    }
    case LegendSign::mark: {
        float const size = scaled(5.5F);
        ImVec2 const middle{from.x + size, from.y};
        list.AddQuadFilled({middle.x - size, middle.y}, {middle.x, middle.y - size},
                           {middle.x + size, middle.y}, {middle.x, middle.y + size}, colour);
        break;
    }
    }
}

void drawLegendRow(LegendRow const& row) {
    ImVec2 const at = ImGui::GetCursorScreenPos();
    drawSign(row, {at.x, at.y + 0.5F * scaled(rowHeight)});
    float const high = ImGui::GetTextLineHeight();
    ImGui::SetCursorScreenPos({at.x + scaled(signWidth), at.y + 0.5F * (scaled(rowHeight) - high)});
    ImGui::TextUnformatted(row.words);
    ImGui::SetCursorScreenPos({at.x, at.y + scaled(rowHeight)});
}

float forceLength(double newtons) {
    return static_cast<float>(arrowLength(newtons, forceDecade));
}

} // namespace

void drawOverlayLegend(Layout& layout, Shown const& shown, float below) {
    constexpr float highest = 210; // with all overlays, pixels at UI scale 1
    constexpr float widest = 330;
    ImVec2 const screen = ImGui::GetIO().DisplaySize;
    Rect const there{{0, static_cast<double>(screen.y - scaled(bottomRow + below + highest))},
                     {static_cast<double>(scaled(cardGap + widest)), static_cast<double>(screen.y)}};
    constexpr std::array others{"goal", "hints", "inspector", "why"};
    bool const room = std::none_of(others.begin(), others.end(), [&](char const* other) {
        auto const card = layout.card(other);
        return card && card->overlaps(there);
    });
    if (!room || (!shown.electricity && !shown.magnetism && !shown.contacts)) {
        return;
    }
    layout.beginCard("legend", "", {.anchor = Anchor::BottomLeft, .offset = {cardGap, bottomRow + below}});
    ImGui::PushFont(theme().fonts.small);
    if (shown.electricity) {
        drawLegendRow({LegendSign::line, palette::live, 60, 4, text("current flows")});
        drawLegendRow({LegendSign::arrow, palette::ink, 24, 3, text("its direction")});
        drawLegendRow({LegendSign::line, palette::inkSoft, 60, 3, text("a wire without current")});
        drawLegendRow({LegendSign::dashes, palette::inkSoft, 60, 3, text("a touch that conducts")});
    }
    if (shown.magnetism) {
        drawLegendRow({LegendSign::arrow, palette::force, forceLength(1), 5, text("force of 1 N")});
        drawLegendRow({LegendSign::arrow, palette::force, forceLength(100), 5, text("100 N")});
        drawLegendRow(
            {LegendSign::arrow, palette::fieldLine, 60, 2, text("magnetic field, from north to south")});
    }
    if (shown.contacts) {
        drawLegendRow({LegendSign::mark, palette::contact, 11, 1, text("objects touch")});
        auto const push = static_cast<float>(contactArrowLength(1, contactArrowUnit));
        drawLegendRow({LegendSign::arrow, palette::contact, push, 3, text("push of 1 N s")});
    }
    ImGui::PopFont();
    ImGui::Dummy({0, 0});
    layout.endCard();
}

} // namespace trembler::ui
