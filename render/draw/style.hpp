// How a shape or a line looks, in the words of the scene and not of OpenGL.
#pragma once

#include "render/draw/colour.hpp"
#include "render/draw/palette.hpp"

#include <cstdint>
#include <optional>

namespace trembler::render {

/// How a surface is drawn, so that materials differ at a glance in more than their colour.
enum class Pattern : std::uint8_t {
    Plain,   ///< flat two-tone, for objects without a material
    Metal,   ///< brushed, with a sheen that stays when the part turns
    Wood,    ///< grain along the part's own x axis
    Glass,   ///< transparent; two reflections
    Rubber,  ///< dark, matt, fine stipple
    Stone,   ///< speckles
    Plastic, ///< even, with one glossy strip
    Copper,  ///< as metal, warmer and shinier
    Water,   ///< transparent; waves that move with time
};

/// The colour of a pattern for which the style states no tint.
[[nodiscard]] Colour colourOf(Pattern pattern);

/// Light around a shape. It is drawn behind the shape and fades out at `reach`.
struct Glow {
    Colour colour = palette::live;
    double reach = 0;     ///< metres; 0 for none
    float strength = 0.F; ///< 0..1, opacity at the shape's edge
};

/// The part of a shape to draw. Bodies made of several shapes look like one if all their rims are drawn first
/// and all their insides after that. Objects that are drawn in another way need only the shadow of their
/// bodies, and the ring if they are selected.
enum class Layer : std::uint8_t { Whole, Rim, Inside, Shadow };

/// How a filled shape looks. Lengths in pixels are at UI scale 1.
struct Style {
    Pattern pattern = Pattern::Plain;
    std::optional<Colour> tint{};          ///< else the pattern's colour; its opacity counts
    float outline = 2.F;                   ///< pixels, inside the shape's true edge; 0 for none
    std::optional<Colour> outlineColour{}; ///< else ink with a touch of the tint
    float alpha = 1.F;                     ///< 0..1, of everything
    float height = 1.F;     ///< how far it seems to stand above the paper: 0 casts no shadow, 1 is usual
    bool flat = false;      ///< one even colour; no pattern
    bool onBody = false;    ///< its shadow falls on earlier shapes of the sheet, as that of a part's detail
    double grain = 0;       ///< metres, size of the pattern; 0 picks it by the shape's size
    bool ghost = false;     ///< not there yet: half transparent, dashed
    bool forbidden = false; ///< may not be there: hatched in the warning colour
    bool selected = false;  ///< ringed in the accent colour
    bool hovered = false;   ///< a little lighter
    Layer layer = Layer::Whole;
    Glow glow{};
};

/// How a line looks. It is as wide as the larger of `width` and `pixels`.
struct Stroke {
    Colour colour = palette::ink;
    double width = 0;    ///< metres: grows with the zoom
    float pixels = 0.F;  ///< pixels at UI scale 1: the same at any zoom
    float outline = 0.F; ///< pixels, dark rim inside the width
    Colour outlineColour = palette::ink;
    float alpha = 1.F;   ///< 0..1
    bool round = false;  ///< shaded like a tube (wires) and not flat (overlays)
    float height = 0.F;  ///< as in Style
    bool onBody = false; ///< as in Style
    Glow glow{};
};

} // namespace trembler::render
