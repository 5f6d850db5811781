#include "render/panels/toolbox_tile.hpp"

#include "render/draw/palette.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>
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

// Shares of the small letters' size.
constexpr float smallerLetters = 0.86F;
constexpr float smallestLetters = 0.68F;

/// How a name is written on a tile: in one line or two, in letters that are as large as fit.
struct WrittenName {
    std::string first;
    std::string second; ///< may be empty
    float size = 1;     ///< share of the small letters'
};

float widthIn(std::string const& text, float share) {
    return share * ImGui::CalcTextSize(text.c_str()).x;
}

/// Cut short with an ellipsis if it does not fit even in the smallest letters.
std::string cutShort(std::string name, float width, float share) {
    std::string shown = name;
    while (widthIn(shown, share) > width && !name.empty()) {
        do {
            auto const last = static_cast<unsigned char>(name.back());
            name.pop_back();
            if ((last & 0xC0U) != 0x80U) {
                break;
            }
        } while (!name.empty());
        shown = name + "…";
    }
    return shown;
}

WrittenName writtenName(std::string const& name, float width) {
    float const whole = widthIn(name, 1);
    if (whole <= width) {
        return {name, {}, 1};
    }
    if (smallerLetters * whole <= width) {
        return {name, {}, width / whole};
    }
    // At the blank that leaves the shortest of both lines' longer one.
    WrittenName written{name, {}, 1};
    float longest = whole;
    for (std::size_t at = name.find(' '); at != std::string::npos; at = name.find(' ', at + 1)) {
        float const longer = std::max(widthIn(name.substr(0, at), 1), widthIn(name.substr(at + 1), 1));
        if (longer < longest) {
            longest = longer;
            written.first = name.substr(0, at);
            written.second = name.substr(at + 1);
        }
    }
    written.size =
        std::clamp(width / longest, smallestLetters, written.second.empty() ? 1.F : smallerLetters);
    written.first = cutShort(written.first, width, written.size);
    written.second = cutShort(written.second, width, written.size);
    return written;
}

/// In the foot of a tile.
void drawName(ImDrawList& list, ImVec2 middle, WrittenName const& name, Colour colour) {
    ImFont* const font = theme().fonts.small;
    float const size = name.size * font->FontSize;
    int const lines = name.second.empty() ? 1 : 2;
    float y = middle.y - 0.5F * size * static_cast<float>(lines);
    for (std::string const* const line : {&name.first, &name.second}) {
        float const width = font->CalcTextSizeA(size, 1e9F, 0, line->c_str()).x;
        list.AddText(font, size, {middle.x - 0.5F * width, y}, imColour(colour), line->c_str());
        y += size;
    }
}

} // namespace

Colour tileGround() {
    return paperLight;
}

TileUse toolboxTile(ToolboxTile const& tile) {
    float const side = scaled(tile.side);
    float const width = std::max(side, scaled(tile.width));
    float const foot = scaled(24);
    ImGui::InvisibleButton(tile.id, {width, side + foot});
    bool const none = tile.count == 0;
    TileUse const use{ImGui::IsItemHovered(), ImGui::IsItemActivated() && !none};
    ImVec2 const low = ImGui::GetItemRectMin();
    ImVec2 const high = ImGui::GetItemRectMax();
    auto& list = *ImGui::GetWindowDrawList();
    ImGui::PushFont(theme().fonts.small);
    WrittenName const name = writtenName(tile.name, width - scaled(8));
    float const written = name.second.empty() ? foot : 2 * name.size * ImGui::GetFontSize() + scaled(6);
    ImGui::PopFont();
    float const rounding = scaled(9);
    bool const lifted = use.hovered && !none;
    list.AddRectFilled({low.x, low.y + scaled(3)}, {high.x, high.y + scaled(2)},
                       imColour(faded(shadow, 0.7F)), rounding);
    list.AddRectFilled(low, high, imColour(tileGround()), rounding);
    if (tile.picture != 0) {
        float const inset = scaled(6);
        // ImGui's type for textures is a pointer in one version and a number in another.
        auto const texture = (ImTextureID) static_cast<std::intptr_t>(tile.picture); // NOLINT
        float const left = 0.5F * (low.x + high.x - side);
        list.AddImage(texture, {left + inset, low.y + inset}, {left + side - inset, low.y + side - inset},
                      {0, 1}, {1, 0}, none ? imColour(faded(rgb(0xFFFFFF), 0.30F)) : IM_COL32_WHITE);
    }
    list.AddRectFilled({low.x, high.y - written}, high,
                       imColour(lifted ? mix(paperShade, accent, 0.22F) : paperShade), rounding,
                       ImDrawFlags_RoundCornersBottom);
    Colour const rim =
        tile.selected ? accent : (lifted ? mix(ink, accent, 0.6F) : mix(paperShade, ink, 0.6F));
    list.AddRect(low, high, imColour(rim), rounding, 0, scaled(tile.selected ? 3.F : 1.6F));
    drawName(list, {0.5F * (low.x + high.x), high.y - 0.5F * written}, name, none ? inkSoft : ink);
    if (tile.count >= 0) {
        drawCount(list, {high.x - scaled(5), low.y + scaled(5)}, tile.count);
    }
    return use;
}

} // namespace trembler::render
