// Colours as the palette writes them, and simple calculations with them.
#pragma once

#include <cstdint>

namespace trembler::render {

/// sRGB with opacity, 0 to 255 each, not premultiplied.
struct Colour {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
    std::uint8_t alpha = 255;

    friend constexpr bool operator==(Colour const&, Colour const&) = default;
};

/// An opaque colour from 0xRRGGBB.
[[nodiscard]] constexpr Colour rgb(std::uint32_t hex) {
    return {static_cast<std::uint8_t>((hex >> 16U) & 0xFFU), static_cast<std::uint8_t>((hex >> 8U) & 0xFFU),
            static_cast<std::uint8_t>(hex & 0xFFU), 255};
}

/// The nearest channel value, for values from 0 to 255.
[[nodiscard]] constexpr std::uint8_t channelFrom(float value) {
    float const up = value + 0.5F;
    return static_cast<std::uint8_t>(up);
}

/// The same colour with the opacity multiplied by `factor` (clamped to 0..1).
[[nodiscard]] constexpr Colour faded(Colour colour, float factor) {
    float const clamped = factor > 0.F ? (factor < 1.F ? factor : 1.F) : 0.F;
    colour.alpha = channelFrom(static_cast<float>(colour.alpha) * clamped);
    return colour;
}

/// The colour that lies `share` (0..1) of the way from one to the other, opacity included.
[[nodiscard]] constexpr Colour mix(Colour from, Colour to, float share) {
    auto const blend = [share](std::uint8_t a, std::uint8_t b) {
        return channelFrom(static_cast<float>(a) * (1.F - share) + static_cast<float>(b) * share);
    };
    return {blend(from.red, to.red), blend(from.green, to.green), blend(from.blue, to.blue),
            blend(from.alpha, to.alpha)};
}

/// One word in the order that vertex attributes and ImGui (IM_COL32) use: red in the lowest byte.
[[nodiscard]] constexpr std::uint32_t packed(Colour colour) {
    return static_cast<std::uint32_t>(colour.red) | (static_cast<std::uint32_t>(colour.green) << 8U) |
           (static_cast<std::uint32_t>(colour.blue) << 16U) |
           (static_cast<std::uint32_t>(colour.alpha) << 24U);
}

} // namespace trembler::render
