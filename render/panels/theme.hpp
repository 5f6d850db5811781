// The look of all panels: one style, one family of letters, one scale.
#pragma once

#include "render/draw/palette.hpp"

#include <imgui.h>

#include <string>

namespace trembler::render {

/// The letters, all of one family. Never null; if no font file is found, all are ImGui's built-in font.
struct Fonts {
    ImFont* body = nullptr;    ///< 17 pixels at UI scale 1; the default
    ImFont* small = nullptr;   ///< 14: counts, units, captions
    ImFont* strong = nullptr;  ///< 17, semi-bold: buttons, names
    ImFont* heading = nullptr; ///< 23, semi-bold: headings of cards
    ImFont* title = nullptr;   ///< 46, bold: the title screen; Latin letters only
    std::string message;       ///< the source of the letters, or the reason for the built-in ones
    bool builtIn = false;
};

/// The data that widgets share; Gui owns it, every function of panels/ finds it through ImGui's context.
struct Theme {
    float scale = 1.F;                                ///< UI scale
    palette::Choice colours = palette::Choice::usual; ///< of ImGui's style
    Fonts fonts;
};

/// The current theme. A Gui must exist.
[[nodiscard]] Theme& theme();

/// Pixels for a length that is stated at UI scale 1.
[[nodiscard]] inline float scaled(float pixels) {
    return pixels * theme().scale;
}

/// Colours as ImGui takes them.
[[nodiscard]] inline ImU32 imColour(Colour colour) {
    return packed(colour);
}
[[nodiscard]] ImVec4 imColour4(Colour colour);

/// Sets ImGui's style for a UI scale: paper, ink and soft corners instead of ImGui's greys.
void applyStyle(float scale);

/// Empties ImGui's font atlas and loads the letters for a UI scale. Looks for Inter (package fonts-inter),
/// then DejaVu (fonts-dejavu-core); signs that Inter lacks come from DejaVu. Never fails: see Fonts::message.
[[nodiscard]] Fonts loadFonts(float scale);

} // namespace trembler::render
