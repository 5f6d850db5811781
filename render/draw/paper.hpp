// The background: warm paper with a grid in world metres.
#pragma once

#include "render/draw/camera.hpp"
#include "render/gl/handle.hpp"
#include "render/gl/program.hpp"

#include <array>

namespace trembler::render {

/// One set of grid lines: their distance in metres and how strongly they show, 0 to 1.
struct Ruling {
    double spacing = 1;
    float strength = 0.F;
};

/// The sets that are seen at a zoom, finest first: 1, 5, 10, 50 and 100 times a power of ten. A set's
/// strength is a function of its distance on the screen alone and starts at 0, so lines appear and disappear
/// gradually while one zooms.
[[nodiscard]] std::array<Ruling, 5> rulingsFor(double pixelsPerMetre, float uiScale);

/// Window thread only.
class Paper {
public:
    /// Throws RenderError if the driver does not take the shaders.
    Paper();
    /// Covers the whole bound target.
    void draw(Camera const& camera, float uiScale) const;

private:
    Program program_;
    GlVertexArray layout_;
};

} // namespace trembler::render
