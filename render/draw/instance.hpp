// One shape as it is sent to the graphics card: 64 bytes, and the numbers that C++ and the shaders must agree
// on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace trembler::render {

// Values of Instance::kind.
inline constexpr std::uint8_t kindBox = 0;     ///< rounded box: also circle, capsule and single segment
inline constexpr std::uint8_t kindPolygon = 1; ///< params: first corner, number of corners
inline constexpr std::uint8_t kindArc =
    2; ///< params: radius, half thickness, cosine and sine of half the sweep
inline constexpr std::uint8_t kindChain =
    3; ///< one segment of a path: params: first, last point looked at, own
inline constexpr std::size_t kindCount = 4;

// Values of Instance::effect.
inline constexpr std::uint8_t effectSolid = 0;
inline constexpr std::uint8_t effectGlow = 1;   ///< outline is the reach
inline constexpr std::uint8_t effectShadow = 2; ///< outline is the softness
inline constexpr std::uint8_t effectFlat = 3;   ///< solid without any shading

// Bits of Instance::flags.
inline constexpr std::uint8_t flagSelected = 1;
inline constexpr std::uint8_t flagGhost = 2;
inline constexpr std::uint8_t flagForbidden = 4;
inline constexpr std::uint8_t flagRim = 8;
inline constexpr std::uint8_t flagInside = 16;
inline constexpr std::uint8_t flagHovered = 32;
inline constexpr std::uint8_t flagFlattened = 64;

/// How many values Instance::pattern has (enum Pattern).
inline constexpr std::size_t patternCount = 9;

/// Lengths in metres; positions relative to the camera's centre, so that 32 bits are enough far from the
/// origin.
struct Instance {
    std::array<float, 2> centre{};
    std::array<float, 2> axis{1.F, 0.F}; ///< cosine and sine of the angle
    std::array<float, 2> half{}; ///< half extents of the shape's box in its own frame, rounding included
    float radius = 0.F;          ///< of the corners
    float outline = 0.F;
    std::array<float, 4> params{};
    std::uint32_t colour = 0;
    std::uint32_t edge = 0;
    std::uint8_t kind = kindBox;
    std::uint8_t effect = effectSolid;
    std::uint8_t pattern = 0;
    std::uint8_t flags = 0;
    float grain = 1.F;
};
static_assert(sizeof(Instance) == 64);

/// A corner of a polygon (in the shape's frame) or a point of a path (relative to the camera's centre).
using Corner = std::array<float, 2>;

} // namespace trembler::render
