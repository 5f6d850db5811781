// Sends shapes to the graphics card: one buffer of instances, one of corners, few draw calls.
#pragma once

#include "render/draw/instance.hpp"
#include "render/gl/handle.hpp"
#include "render/gl/program.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>

namespace trembler::render {

/// The values that all shapes of one call share.
struct BatchView {
    float halfWidth = 1.F;  ///< metres from the middle of the view to its right edge
    float halfHeight = 1.F; ///< metres to its upper edge
    float metresPerPixel = 0.01F;
    float uiScale = 1.F;
    float time = 0.F;              ///< s, moves the water
    std::array<float, 2> flatAt{}; ///< metres from the middle of the view: see flagFlattened
    std::array<float, 2> flatBy{1.F, 1.F};
};

/// Window thread only.
class ShapeBatch {
public:
    /// Throws RenderError if the driver does not take the shaders.
    ShapeBatch();

    /// Draws the shapes in the order given, over the contents of the bound target. Leaves blending off and
    /// nothing bound.
    void draw(std::span<Instance const> shapes, std::span<Corner const> corners, BatchView const& view);

private:
    /// The features that a shader is compiled for. Software OpenGL runs every branch of a shader for every
    /// pixel, whichever is taken; one small program per look makes a frame two to four times as fast there.
    struct Look {
        bool light = false;  ///< glow or shadow
        bool shaded = false; ///< two tones and a pattern
        bool marked = false; ///< selected, hovered, ghost or forbidden
        std::uint8_t pattern = 0;
        std::uint8_t kind = 0;

        friend bool operator==(Look const&, Look const&) = default;
    };
    static constexpr std::size_t lookCount = kindCount * 2 * (2 + patternCount);
    [[nodiscard]] static Look lookOf(Instance const& shape);
    [[nodiscard]] static std::size_t indexOf(Look const& look);
    [[nodiscard]] Program const& programFor(Look const& look);
    void setView(Program const& program, BatchView const& view) const;
    /// Makes the attributes start at one instance (OpenGL 3.3 cannot say so in the draw call).
    static void startAt(std::size_t first);

    std::array<std::optional<Program>, lookCount> programs_; // compiled when first needed
    GlVertexArray layout_;
    GlBuffer instances_;
    GlBuffer corners_;
    GlTexture cornerView_;
};

} // namespace trembler::render
