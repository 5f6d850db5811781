// The strokes and areas of which icons consist.
#pragma once

#include <imgui.h>

namespace trembler::render {

/// Draws in a square from -1 to 1, y down.
class IconPen {
public:
    IconPen(ImDrawList& list, ImVec2 centre, float size, ImU32 colour)
        : list_(list), centre_(centre), half_(0.5F * size), colour_(colour) {}

    [[nodiscard]] ImVec2 at(float x, float y) const { return {centre_.x + half_ * x, centre_.y + half_ * y}; }
    [[nodiscard]] float thick() const { return 0.24F * half_; }

    void line(float x1, float y1, float x2, float y2) const {
        list_.AddLine(at(x1, y1), at(x2, y2), colour_, thick());
        dot(x1, y1, 0.12F);
        dot(x2, y2, 0.12F);
    }
    void triangle(float x1, float y1, float x2, float y2, float x3, float y3) const {
        // ImGui smooths the edges of clockwise triangles only (y is down).
        bool const clockwise = (x2 - x1) * (y3 - y1) - (x3 - x1) * (y2 - y1) > 0.F;
        list_.AddTriangleFilled(at(x1, y1), clockwise ? at(x2, y2) : at(x3, y3),
                                clockwise ? at(x3, y3) : at(x2, y2), colour_);
    }
    void block(float x1, float y1, float x2, float y2, float rounding = 0.12F) const {
        list_.AddRectFilled(at(x1, y1), at(x2, y2), colour_, rounding * half_);
    }
    void frame(float x1, float y1, float x2, float y2, float rounding) const {
        list_.AddRect(at(x1, y1), at(x2, y2), colour_, rounding * half_, 0, thick());
    }
    void dot(float x, float y, float radius) const {
        list_.AddCircleFilled(at(x, y), radius * half_, colour_);
    }
    void circle(float x, float y, float radius) const {
        list_.AddCircle(at(x, y), radius * half_, colour_, 0, thick());
    }
    void arc(float x, float y, float radius, float from, float to) const {
        list_.PathArcTo(at(x, y), radius * half_, from, to, 24);
        list_.PathStroke(colour_, 0, thick());
    }

private:
    ImDrawList& list_;
    ImVec2 centre_;
    float half_;
    ImU32 colour_;
};

} // namespace trembler::render
