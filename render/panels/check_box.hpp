// A box to tick whose outline is seen on paper, ticked or not.
#pragma once

#include "render/draw/palette.hpp"
#include "render/panels/theme.hpp"

namespace trembler::render {

/// As ImGui::Checkbox: returns whether it was changed.
inline bool checkBox(char const* label, bool* value) {
    ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, scaled(1.5F));
    ImGui::PushStyleColor(ImGuiCol_Border, imColour4(mix(palette::paperShade, palette::ink, 0.45F)));
    bool const changed = ImGui::Checkbox(label, value);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    return changed;
}

} // namespace trembler::render
