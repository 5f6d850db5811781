#include "render/panels/world_label.hpp"

#include "render/panels/theme.hpp"

#include <array>

namespace trembler::render {
namespace {

constexpr Point chipMargin{7, 3}; // pixels at UI scale 1

} // namespace

Point chipSize(char const* text) {
    ImFont* const font = theme().fonts.small;
    ImVec2 const extent = font->CalcTextSizeA(font->FontSize, 1e9F, 0.F, text);
    return {extent.x + 2 * scaled(static_cast<float>(chipMargin.x)),
            extent.y + 2 * scaled(static_cast<float>(chipMargin.y))};
}

void worldLabel(Camera const& camera, Point at, char const* text, LabelOptions const& options) {
    Point const screen = camera.toScreen(at);
    if (!finite(screen)) {
        return;
    }
    auto const& fonts = theme().fonts;
    bool const inWorld = options.metresHigh > 0;
    auto const high = static_cast<float>(options.metresHigh * camera.pixelsPerMetre);
    // The font that is enlarged less.
    ImFont* font = !inWorld ? fonts.small : (high > fonts.heading->FontSize ? fonts.title : fonts.heading);
    float const size = inWorld ? high : font->FontSize;
    if (size < 4.F || size > 2000.F) {
        return; // too small to read, or larger than the window
    }
    ImVec2 const extent = font->CalcTextSizeA(size, 1e9F, 0.F, text);
    ImVec2 const middle{static_cast<float>(screen.x), static_cast<float>(screen.y) + scaled(options.below)};
    ImVec2 const low{middle.x - 0.5F * extent.x, middle.y - 0.5F * extent.y};
    auto& list = *ImGui::GetBackgroundDrawList();
    if (options.look == LabelLook::Chip) {
        float const x = scaled(static_cast<float>(chipMargin.x));
        float const y = scaled(static_cast<float>(chipMargin.y));
        ImVec2 const from{low.x - x, low.y - y};
        ImVec2 const to{low.x + extent.x + x, low.y + extent.y + y};
        list.AddRectFilled(from, to, imColour(faded(palette::paperLight, 0.92F)), scaled(6));
        list.AddRect(from, to, imColour(mix(palette::paperShade, palette::ink, 0.45F)), scaled(6), 0,
                     scaled(1.2F));
    } else if (!inWorld) {
        float const halo = scaled(1.3F);
        std::array const around{ImVec2{1, 0},        ImVec2{-1, 0},       ImVec2{0, 1},
                                ImVec2{0, -1},       ImVec2{0.7F, 0.7F},  ImVec2{-0.7F, 0.7F},
                                ImVec2{0.7F, -0.7F}, ImVec2{-0.7F, -0.7F}};
        for (ImVec2 const& side : around) {
            list.AddText(font, size, {low.x + halo * side.x, low.y + halo * side.y},
                         imColour(faded(palette::paperLight, 0.75F)), text);
        }
    }
    list.AddText(font, size, low, imColour(options.colour), text);
}

} // namespace trembler::render
