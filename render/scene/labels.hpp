// The words on objects ("look": {"label": ...}); they are written with the panels, which have a font.
#pragma once

#include "render/scene/facts/poses.hpp"

#include <string_view>
#include <vector>

namespace trembler::render {

/// For worldLabel(camera, at, text, {.colour, .metresHigh}).
struct SceneLabel {
    Point at;              ///< middle of the word, in the world
    double metresHigh = 0; ///< fits the object
    std::string_view text; ///< valid until the world changes
    Colour colour;         ///< readable on the object
};

/// Empty labels, and those of objects that carry a sign of electricity there already, are left out.
[[nodiscard]] std::vector<SceneLabel> sceneLabels(World const& world, Poses const& poses = {},
                                                  double alpha = 1);

} // namespace trembler::render
