// A picture that OpenGL draws into instead of the screen: offscreen windows, screenshots of any size, the
// small pictures of parts in the toolbox.
#pragma once

#include "render/draw/colour.hpp"
#include "render/gl/handle.hpp"
#include "render/gl/image.hpp"

namespace trembler::render {

/// An RGBA target without depth. Window thread only.
class Framebuffer {
public:
    /// Throws RenderError if the size is not positive, or larger than the driver allows.
    explicit Framebuffer(Size size);

    [[nodiscard]] Size size() const { return size_; }
    /// Subsequent drawing goes into this, over the whole area. The caller rebinds its own target afterwards.
    void bind() const;
    /// OpenGL's name of the picture, for ImGui::Image; its first row is the bottom one, so v runs from 1 to
    /// 0.
    [[nodiscard]] unsigned texture() const { return texture_.name(); }
    /// Waits for the drawing to end and copies it.
    [[nodiscard]] Image read() const;

private:
    Size size_;
    GlTexture texture_;
    GlFramebuffer framebuffer_;
};

/// Fills the bound target with one colour, opacity included.
void clearBound(Colour colour);

/// Copies the lower left `size` pixels of the bound target (waits for the drawing to end). Rows come out top
/// down. Opacity comes out as 255: the screen shows no other.
[[nodiscard]] Image readBoundPixels(Size size);

} // namespace trembler::render
