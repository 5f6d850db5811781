#include "render/draw/palette.hpp"
#include "render/panels/theme.hpp"

#include <initializer_list>
#include <utility>

namespace trembler::render {

namespace {

using namespace palette;

void applyColours(ImGuiStyle& style) {
    constexpr Colour nothing{0, 0, 0, 0};
    std::initializer_list<std::pair<ImGuiCol, Colour>> const colours{
        {ImGuiCol_Text, ink},
        {ImGuiCol_TextDisabled, inkSoft},
        {ImGuiCol_WindowBg, paperLight},
        {ImGuiCol_ChildBg, nothing},
        {ImGuiCol_PopupBg, paperLight},
        {ImGuiCol_Border, mix(paperShade, ink, 0.45F)},
        {ImGuiCol_BorderShadow, nothing},
        {ImGuiCol_FrameBg, mix(paperLight, paperShade, 0.75F)},
        {ImGuiCol_FrameBgHovered, paperShade},
        {ImGuiCol_FrameBgActive, mix(paperShade, accent, 0.20F)},
        {ImGuiCol_TitleBg, paperShade},
        {ImGuiCol_TitleBgActive, mix(paperShade, grid, 0.35F)},
        {ImGuiCol_TitleBgCollapsed, paperShade},
        {ImGuiCol_MenuBarBg, paperShade},
        {ImGuiCol_ScrollbarBg, nothing},
        {ImGuiCol_ScrollbarGrab, mix(paperShade, ink, 0.25F)},
        {ImGuiCol_ScrollbarGrabHovered, mix(paperShade, ink, 0.40F)},
        {ImGuiCol_ScrollbarGrabActive, mix(paperShade, ink, 0.55F)},
        {ImGuiCol_CheckMark, accent},
        {ImGuiCol_SliderGrab, accent},
        {ImGuiCol_SliderGrabActive, accentDeep},
        {ImGuiCol_Button, mix(paperLight, paperShade, 0.85F)},
        {ImGuiCol_ButtonHovered, mix(paperShade, accent, 0.16F)},
        {ImGuiCol_ButtonActive, mix(paperShade, accent, 0.34F)},
        {ImGuiCol_Header, mix(paperShade, accent, 0.14F)},
        {ImGuiCol_HeaderHovered, mix(paperShade, accent, 0.22F)},
        {ImGuiCol_HeaderActive, mix(paperShade, accent, 0.34F)},
        {ImGuiCol_Separator, mix(paperShade, ink, 0.20F)},
        {ImGuiCol_SeparatorHovered, accent},
        {ImGuiCol_SeparatorActive, accentDeep},
        {ImGuiCol_ResizeGrip, nothing},
        {ImGuiCol_ResizeGripHovered, faded(accent, 0.5F)},
        {ImGuiCol_ResizeGripActive, accent},
        {ImGuiCol_Tab, paperShade},
        {ImGuiCol_TabHovered, mix(paperShade, accent, 0.30F)},
        {ImGuiCol_TabActive, paperLight},
        {ImGuiCol_TabUnfocused, paperShade},
        {ImGuiCol_TabUnfocusedActive, paperLight},
        {ImGuiCol_PlotLines, accent},
        {ImGuiCol_PlotLinesHovered, warning},
        {ImGuiCol_PlotHistogram, accent},
        {ImGuiCol_PlotHistogramHovered, warning},
        {ImGuiCol_TableHeaderBg, paperShade},
        {ImGuiCol_TableBorderStrong, mix(paperShade, ink, 0.25F)},
        {ImGuiCol_TableBorderLight, paperShade},
        {ImGuiCol_TableRowBg, nothing},
        {ImGuiCol_TableRowBgAlt, faded(paperShade, 0.35F)},
        {ImGuiCol_TextSelectedBg, faded(accent, 0.30F)},
        {ImGuiCol_DragDropTarget, accent},
        {ImGuiCol_NavHighlight, accent},
        {ImGuiCol_ModalWindowDimBg, faded(ink, 0.45F)},
    };
    for (auto const& [which, colour] : colours) {
        style.Colors[which] = imColour4(colour);
    }
}

} // namespace

Theme& theme() {
    return *static_cast<Theme*>(ImGui::GetIO().UserData);
}

ImVec4 imColour4(Colour colour) {
    return ImGui::ColorConvertU32ToFloat4(packed(colour));
}

void applyStyle(float scale) {
    ImGuiStyle style;
    applyColours(style);
    style.WindowPadding = {18, 16};
    style.WindowRounding = 12;
    style.WindowBorderSize = 1.5F;
    style.WindowTitleAlign = {0.5F, 0.5F};
    style.ChildRounding = 8;
    style.PopupRounding = 8;
    style.PopupBorderSize = 1.5F;
    style.FramePadding = {12, 7};
    style.FrameRounding = 7;
    style.ItemSpacing = {10, 9};
    style.ItemInnerSpacing = {8, 6};
    style.CellPadding = {8, 4};
    style.IndentSpacing = 20;
    style.ScrollbarSize = 12;
    style.ScrollbarRounding = 6;
    style.GrabMinSize = 16;
    style.GrabRounding = 8;
    style.TabRounding = 7;
    style.WindowMenuButtonPosition = ImGuiDir_None;
    float const border = style.WindowBorderSize;
    style.ScaleAllSizes(scale);
    // Borders are not scaled by that.
    style.WindowBorderSize = border * scale;
    style.PopupBorderSize = border * scale;
    ImGui::GetStyle() = style;
}

} // namespace trembler::render
