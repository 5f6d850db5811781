// Words in the world: names, pole letters, values beside arrows.
#pragma once

#include "render/draw/camera.hpp"
#include "render/draw/colour.hpp"
#include "render/draw/palette.hpp"

#include <cstdint>

namespace trembler::render {

enum class LabelLook : std::uint8_t {
    Plain, ///< letters with a thin halo of paper, so that they can be read on anything
    Chip,  ///< on a small card
};

struct LabelOptions {
    LabelLook look = LabelLook::Plain;
    Colour colour = palette::ink;
    double metresHigh =
        0;             ///< letters this high in the world, scaling with the zoom; 0 for the small UI letters
    float below = 0.F; ///< pixels at UI scale 1 by which the text's middle lies under the point
};

/// Writes `text` centred on a world point, over the world and under all panels. Between Gui::beginFrame and
/// endFrame; `camera` as given to the canvas.
void worldLabel(Camera const& camera, Point at, char const* text, LabelOptions const& options = {});
/// Width and height of such a text as LabelLook::Chip in the small UI letters, in pixels.
[[nodiscard]] Point chipSize(char const* text);

} // namespace trembler::render
