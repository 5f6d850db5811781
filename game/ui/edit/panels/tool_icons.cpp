#include "game/ui/edit/panels/tool_icons.hpp"

#include "render/draw/palette.hpp"
#include "render/panels/icons.hpp"
#include "render/panels/theme.hpp"

#include <array>

namespace trembler::ui {
namespace {

using namespace render;

/// Draws in a square from -1 to 1, y down.
struct ToolPen {
    ImDrawList& list;
    ImVec2 centre;
    float half;
    ImU32 colour;

    [[nodiscard]] ImVec2 at(float x, float y) const { return {centre.x + half * x, centre.y + half * y}; }
    [[nodiscard]] float thick() const { return 0.2F * half; }
    void line(float x1, float y1, float x2, float y2) const {
        list.AddLine(at(x1, y1), at(x2, y2), colour, thick());
    }
    void dot(float x, float y, float radius) const { list.AddCircleFilled(at(x, y), radius * half, colour); }
    void ring(float x, float y, float radius) const {
        list.AddCircle(at(x, y), radius * half, colour, 0, thick());
    }
    void frame(float x1, float y1, float x2, float y2, float rounding = 0.1F) const {
        list.AddRect(at(x1, y1), at(x2, y2), colour, rounding * half, 0, thick());
    }
    /// A rectangle of dashes.
    void dashes(float side) const {
        for (float const s : std::array{-1.F, 1.F}) {
            for (float const t : std::array{-0.75F, 0.F, 0.75F}) {
                float const from = side * (t - 0.16F);
                float const to = side * (t + 0.16F);
                line(from, s * side, to, s * side);
                line(s * side, from, s * side, to);
            }
        }
    }
};

void arrowHead(ToolPen const& pen) {
    std::array const points{pen.at(-0.5F, -0.85F), pen.at(-0.5F, 0.65F), pen.at(-0.12F, 0.3F),
                            pen.at(0.18F, 0.9F),   pen.at(0.46F, 0.76F), pen.at(0.18F, 0.2F),
                            pen.at(0.66F, 0.14F)};
    pen.list.AddPolyline(points.data(), static_cast<int>(points.size()), pen.colour, ImDrawFlags_Closed,
                         0.8F * pen.thick());
    pen.list.AddTriangleFilled(points[0], points[6], points[1], pen.colour);
}

void capsuleIcon(ToolPen const& pen) {
    pen.frame(-0.9F, -0.42F, 0.9F, 0.42F, 0.42F);
}

void polygonIcon(ToolPen const& pen) {
    std::array const points{pen.at(-0.2F, -0.8F), pen.at(0.85F, -0.3F), pen.at(0.5F, 0.75F),
                            pen.at(-0.55F, 0.6F), pen.at(-0.85F, -0.1F)};
    pen.list.AddPolyline(points.data(), static_cast<int>(points.size()), pen.colour, ImDrawFlags_Closed,
                         pen.thick());
    for (ImVec2 const& point : points) {
        pen.list.AddCircleFilled(point, 0.17F * pen.half, pen.colour);
    }
}

void jointIcon(ToolPen const& pen) {
    pen.line(-0.9F, 0.6F, -0.2F, 0.15F);
    pen.line(0.2F, -0.15F, 0.9F, -0.6F);
    pen.ring(0, 0, 0.32F);
    pen.dot(0, 0, 0.12F);
}

void wireIcon(ToolPen const& pen) {
    pen.dot(-0.75F, -0.4F, 0.2F);
    pen.dot(0.75F, -0.4F, 0.2F);
    pen.list.AddBezierCubic(pen.at(-0.75F, -0.4F), pen.at(-0.5F, 0.9F), pen.at(0.5F, 0.9F),
                            pen.at(0.75F, -0.4F), pen.colour, pen.thick());
}

void flag(ToolPen const& pen) {
    pen.line(-0.3F, -0.5F, -0.3F, 0.55F);
    pen.list.AddTriangleFilled(pen.at(-0.3F, -0.55F), pen.at(0.45F, -0.25F), pen.at(-0.3F, 0.05F),
                               pen.colour);
}

void bars(ToolPen const& pen) {
    float y = -0.55F;
    for (float const knob : std::array{0.35F, -0.4F, 0.1F}) {
        pen.line(-0.85F, y, 0.85F, y);
        pen.dot(knob, y, 0.24F);
        y += 0.55F;
    }
}

struct Faces {
    Colour body;
    Colour text;
};

Faces facesOf(bool on, bool hovered) {
    if (on) {
        return {mix(palette::accent, palette::paperLight, 0.12F), palette::paperLight};
    }
    return {hovered ? mix(palette::paperLight, palette::accent, 0.16F)
                    : mix(palette::paperLight, palette::paperShade, 0.3F),
            palette::ink};
}

struct Pressed {
    bool clicked = false;
    ImVec2 middle;
    ImU32 colour = 0;
};

Pressed plainButton(char const* id, char const* tip, bool on, float width, float height) {
    bool const clicked = ImGui::InvisibleButton(id, {scaled(width), scaled(height)});
    bool const hovered = ImGui::IsItemHovered();
    Faces const faces = facesOf(on, hovered);
    ImVec2 const low = ImGui::GetItemRectMin();
    ImVec2 const high = ImGui::GetItemRectMax();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, imColour(faces.body), scaled(7));
    list.AddRect(low, high, imColour(mix(palette::ink, palette::paperShade, 0.45F)), scaled(7), 0,
                 scaled(1.3F));
    if (ImGui::IsItemFocused() && ImGui::GetIO().NavVisible) {
        list.AddRect(low, high, imColour(palette::accent), scaled(7), 0, scaled(3));
    }
    if (hovered && tip != nullptr) {
        ImGui::SetTooltip("%s", tip);
    }
    return {clicked, {0.5F * (low.x + high.x), 0.5F * (low.y + high.y)}, imColour(faces.text)};
}

} // namespace

void drawToolIcon(ImDrawList& list, Tool tool, ImVec2 centre, float size, ImU32 colour) {
    ToolPen const pen{list, centre, 0.5F * size, colour};
    switch (tool) {
    case Tool::select:
        return arrowHead(pen);
    case Tool::box:
        return pen.frame(-0.8F, -0.6F, 0.8F, 0.6F);
    case Tool::disc:
        return pen.ring(0, 0, 0.75F);
    case Tool::capsule:
        return capsuleIcon(pen);
    case Tool::polygon:
        return polygonIcon(pen);
    case Tool::joint:
        return jointIcon(pen);
    case Tool::wire:
        return wireIcon(pen);
    case Tool::placing:
        pen.dashes(0.85F);
        pen.line(-0.35F, 0, 0.35F, 0);
        return pen.line(0, -0.35F, 0, 0.35F);
    case Tool::goalArea:
        pen.dashes(0.85F);
        return flag(pen);
    }
}

void drawTabIcon(ImDrawList& list, Tab tab, ImVec2 centre, float size, ImU32 colour) {
    ToolPen const pen{list, centre, 0.5F * size, colour};
    switch (tab) {
    case Tab::parts:
        pen.frame(-0.8F, -0.8F, -0.1F, -0.1F);
        pen.frame(-0.8F, 0.15F, -0.1F, 0.85F);
        pen.frame(0.15F, 0.15F, 0.85F, 0.85F);
        return pen.ring(0.5F, -0.45F, 0.36F);
    case Tab::outline:
        return drawIcon(list, Icon::List, centre, size, colour);
    case Tab::properties:
        return bars(pen);
    case Tab::goals:
        return drawIcon(list, Icon::Tick, centre, size, colour);
    case Tab::level:
        return drawIcon(list, Icon::Script, centre, size, colour);
    case Tab::solutions:
        return drawIcon(list, Icon::Record, centre, size, colour);
    case Tab::report: // a sheet with a chart
        pen.frame(-0.7F, -0.9F, 0.7F, 0.9F);
        pen.line(-0.35F, 0.55F, -0.35F, 0.1F);
        pen.line(0, 0.55F, 0, -0.45F);
        return pen.line(0.35F, 0.55F, 0.35F, -0.15F);
    case Tab::search: // a magnifying glass
        pen.ring(-0.2F, -0.2F, 0.55F);
        return pen.line(0.22F, 0.22F, 0.85F, 0.85F);
    case Tab::problems:
        pen.list.AddTriangle(pen.at(0, -0.8F), pen.at(0.9F, 0.75F), pen.at(-0.9F, 0.75F), colour,
                             pen.thick());
        pen.line(0, -0.25F, 0, 0.25F);
        return pen.dot(0, 0.52F, 0.12F);
    }
}

bool toolButton(char const* id, Tool tool, char const* tip, bool on, float side) {
    Pressed const pressed = plainButton(id, tip, on, side, side);
    drawToolIcon(*ImGui::GetWindowDrawList(), tool, pressed.middle, scaled(0.5F * side), pressed.colour);
    return pressed.clicked;
}

bool tabButton(char const* id, Tab tab, char const* tip, bool on, float width, float height) {
    Pressed const pressed = plainButton(id, tip, on, width, height);
    drawTabIcon(*ImGui::GetWindowDrawList(), tab, pressed.middle, scaled(0.5F * height), pressed.colour);
    return pressed.clicked;
}

} // namespace trembler::ui
