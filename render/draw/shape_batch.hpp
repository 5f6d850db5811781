// Sends shapes to the graphics card: one buffer of instances, one of corners, one draw call.
#pragma once

#include "render/draw/instance.hpp"
#include "render/gl/handle.hpp"
#include "render/gl/program.hpp"

#include <span>

namespace trembler::render {

/// What all shapes of one call have in common.
struct BatchView {
    float halfWidth = 1.F;  ///< metres from the middle of the view to its right edge
    float halfHeight = 1.F; ///< metres to its upper edge
    float metresPerPixel = 0.01F;
    float uiScale = 1.F;
    float time = 0.F; ///< s, moves the water
};

/// Window thread only.
class ShapeBatch {
public:
    /// Throws RenderError if the driver does not take the shaders.
    ShapeBatch();

    /// Draws the shapes in the order given over what the bound target shows. Leaves blending off and nothing
    /// bound.
    void draw(std::span<Instance const> shapes, std::span<Corner const> corners, BatchView const& view) const;

private:
    Program program_;
    GlVertexArray layout_;
    GlBuffer instances_;
    GlBuffer corners_;
    GlTexture cornerView_;
};

} // namespace trembler::render
