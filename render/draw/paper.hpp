// The background: warm paper with a grid in world metres.
#pragma once

#include "render/draw/camera.hpp"
#include "render/gl/handle.hpp"
#include "render/gl/program.hpp"

namespace trembler::render {

/// The distance between grid lines, metres: the finest that is drawn (and fades in) and the next two, each ten times
/// as far apart. A function of the zoom alone: a power of ten, never closer than about eight pixels at UI scale 1.
struct Ruling {
    double fine = 0.1;
    float fineStrength = 0.F; ///< 0..1, how far the finest lines have faded in
};
[[nodiscard]] Ruling rulingFor(double pixelsPerMetre, float uiScale);

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
