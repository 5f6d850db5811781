#include "render/panels/toolbox_tile.hpp"

#include "render/draw/palette.hpp"
#include "render/panels/theme.hpp"

#include <cstdint>
#include <string>

namespace trembler::render {

namespace {

using namespace palette;

void drawCount(ImDrawList& list, ImVec2 corner, int count) {
    ImGui::PushFont(theme().fonts.strong);
    std::string const text = std::to_string(count);
    ImVec2 const size = ImGui::CalcTextSize(text.c_str());
    float const half = 0.5F * size.y + scaled(1);
    float const width = std::max(size.x + scaled(10), 2 * half);
    ImVec2 const low{corner.x - width, corner.y};
    ImVec2 const high{corner.x, corner.y + 2 * half};
    list.AddRectFilled(low, high, imColour(count > 0 ? ink : mix(paperShade, ink, 0.45F)), half);
    list.AddText({0.5F * (low.x + high.x - size.x), 0.5F * (low.y + high.y - size.y)}, imColour(paperLight),
                 text.c_str());
    ImGui::PopFont();
}

/// The name in the small letters, cut short with an ellipsis if it is too wide.
void drawName(ImDrawList& list, ImVec2 middle, float width, std::string name, Colour colour) {
    ImGui::PushFont(theme().fonts.small);
    std::string shown = name;
    while (ImGui::CalcTextSize(shown.c_str()).x > width && !name.empty()) {
        do {
            auto const last = static_cast<unsigned char>(name.back());
            name.pop_back();
            if ((last & 0xC0U) != 0x80U) {
                break;
            }
        } while (!name.empty());
        shown = name + "…";
    }
    ImVec2 const size = ImGui::CalcTextSize(shown.c_str());
    list.AddText({middle.x - 0.5F * size.x, middle.y - 0.5F * size.y}, imColour(colour), shown.c_str());
    ImGui::PopFont();
}

} // namespace

Colour tileGround() {
    return paperLight;
}

TileUse toolboxTile(ToolboxTile const& tile) {
    float const side = scaled(tile.side);
    float const foot = scaled(24);
    ImGui::InvisibleButton(tile.id, {side, side + foot});
    bool const none = tile.count == 0;
    TileUse const use{ImGui::IsItemHovered(), ImGui::IsItemActivated() && !none};
    ImVec2 const low = ImGui::GetItemRectMin();
    ImVec2 const high = ImGui::GetItemRectMax();
    auto& list = *ImGui::GetWindowDrawList();
    float const rounding = scaled(9);
    bool const lifted = use.hovered && !none;
    list.AddRectFilled({low.x, low.y + scaled(3)}, {high.x, high.y + scaled(2)},
                       imColour(faded(shadow, 0.7F)), rounding);
    list.AddRectFilled(low, high, imColour(tileGround()), rounding);
    if (tile.picture != 0) {
        float const inset = scaled(6);
        // ImGui's type for textures is a pointer in one version and a number in another.
        auto const texture = (ImTextureID) static_cast<std::intptr_t>(tile.picture); // NOLINT
        list.AddImage(texture, {low.x + inset, low.y + inset}, {high.x - inset, low.y + side - inset}, {0, 1},
                      {1, 0}, none ? imColour(faded(rgb(0xFFFFFF), 0.30F)) : IM_COL32_WHITE);
    }
    list.AddRectFilled({low.x, high.y - foot}, high,
                       imColour(lifted ? mix(paperShade, accent, 0.22F) : paperShade), rounding,
                       ImDrawFlags_RoundCornersBottom);
    Colour const rim =
        tile.selected ? accent : (lifted ? mix(ink, accent, 0.6F) : mix(paperShade, ink, 0.6F));
    list.AddRect(low, high, imColour(rim), rounding, 0, scaled(tile.selected ? 3.F : 1.6F));
    drawName(list, {0.5F * (low.x + high.x), high.y - 0.5F * foot}, side - scaled(10), tile.name,
             none ? inkSoft : ink);
    if (tile.count >= 0) {
        drawCount(list, {high.x - scaled(5), low.y + scaled(5)}, tile.count);
    }
    return use;
}

} // namespace trembler::render
