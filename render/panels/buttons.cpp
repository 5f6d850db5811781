#include "render/panels/buttons.hpp"

#include "render/draw/palette.hpp"
#include "render/panels/theme.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <string_view>

namespace trembler::render {

namespace {

using namespace palette;

struct Face {
    Colour body;
    Colour lip;
    Colour text;
};

Face faceOf(ButtonLook look, bool hovered, bool enabled) {
    Face face{mix(paperLight, paperShade, 0.30F), mix(paperShade, ink, 0.22F), ink};
    if (look == ButtonLook::Primary) {
        face = {accent, accentDeep, paperLight};
    } else if (look == ButtonLook::Danger) {
        face = {warning, mix(warning, ink, 0.40F), paperLight};
    }
    if (!enabled) {
        return {mix(paperLight, paperShade, 0.5F), paperShade, mix(paperShade, ink, 0.40F)};
    }
    if (hovered) {
        // Light words on a coloured button stay as easy to read under the mouse.
        face.body = mix(face.body, look == ButtonLook::Quiet ? accent : ink, 0.14F);
    }
    return face;
}

/// Draws body, lip and rim; returns where the middle of the face is.
ImVec2 drawFace(ImVec2 low, ImVec2 high, Face const& face, bool down) {
    auto& list = *ImGui::GetWindowDrawList();
    float const lip = scaled(4);
    float const rounding = scaled(9);
    float const rim = scaled(buttonOutline);
    float const sunk = down ? lip - scaled(1) : 0.F;
    Colour const line = mix(ink, face.body, 0.15F);
    list.AddRectFilled({low.x, low.y + sunk}, high, imColour(face.lip), rounding);
    list.AddRectFilled({low.x, low.y + sunk}, {high.x, high.y - lip + sunk}, imColour(face.body), rounding);
    list.AddRect({low.x, low.y + sunk}, high, imColour(line), rounding, 0, rim);
    return {0.5F * (low.x + high.x), 0.5F * (low.y + high.y - lip) + sunk};
}

/// s, so that no tip appears over a button that is pressed at once.
constexpr float tipDelay = 0.45F;

void tipFor(char const* tip) {
    if (tip == nullptr || *tip == '\0' || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) ||
        ImGui::GetCurrentContext()->HoveredIdTimer < tipDelay) {
        return;
    }
    // Beside the button, never over its neighbours: above it in the lower half of the window, else below.
    ImVec2 const low = ImGui::GetItemRectMin();
    ImVec2 const high = ImGui::GetItemRectMax();
    ImVec2 const screen = ImGui::GetIO().DisplaySize;
    bool const right = low.x + high.x > screen.x;
    bool const bottom = low.y + high.y > screen.y;
    ImGui::SetNextWindowPos({right ? high.x : low.x, bottom ? low.y - scaled(8) : high.y + scaled(8)},
                            ImGuiCond_Always, {right ? 1.F : 0.F, bottom ? 1.F : 0.F});
    ImGui::SetTooltip("%s", tip);
}

} // namespace

bool bigButton(char const* label, ButtonOptions const& options) {
    std::string_view const shown = std::string_view(label).substr(0, std::string_view(label).find("##"));
    char const* end = shown.data() + shown.size();
    ImGui::PushFont(theme().fonts.strong);
    ImVec2 const text = ImGui::CalcTextSize(shown.data(), end);
    float const icon = options.icon == Icon::None ? 0.F : ImGui::GetFontSize();
    float const gap = icon > 0 && !shown.empty() ? scaled(9) : 0.F;
    float const content = icon + gap + text.x;
    float width = content + scaled(36);
    if (options.width > 0) {
        width = scaled(options.width);
    } else if (options.width < 0) {
        width = std::max(content + scaled(6), ImGui::GetContentRegionAvail().x);
    }
    ImGui::BeginDisabled(!options.enabled);
    bool const clicked = ImGui::InvisibleButton(label, {width, text.y + scaled(24)});
    ImGui::EndDisabled();
    bool const hovered = ImGui::IsItemHovered();
    auto const face = faceOf(options.look, hovered, options.enabled);
    ImVec2 const middle =
        drawFace(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), face, hovered && ImGui::IsItemActive());
    auto& list = *ImGui::GetWindowDrawList();
    float const left = middle.x - 0.5F * content;
    drawIcon(list, options.icon, {left + 0.5F * icon, middle.y}, icon, imColour(face.text));
    list.AddText({left + icon + gap, middle.y - 0.5F * text.y}, imColour(face.text), shown.data(), end);
    ImGui::PopFont();
    tipFor(options.tip);
    return clicked && options.enabled;
}

bool iconButton(char const* id, Icon icon, char const* tip, bool on, bool enabled) {
    float const side = scaled(40);
    ImGui::BeginDisabled(!enabled);
    bool const clicked = ImGui::InvisibleButton(id, {side, side + scaled(2)});
    ImGui::EndDisabled();
    bool const hovered = ImGui::IsItemHovered();
    auto face = faceOf(ButtonLook::Quiet, hovered, enabled);
    if (on && enabled) {
        face = {mix(accent, paperLight, 0.12F), accentDeep, paperLight};
    }
    bool const down = on || (hovered && ImGui::IsItemActive());
    ImVec2 const middle = drawFace(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), face, down);
    drawIcon(*ImGui::GetWindowDrawList(), icon, middle, 0.46F * side, imColour(face.text));
    tipFor(tip);
    return clicked && enabled;
}

} // namespace trembler::render
