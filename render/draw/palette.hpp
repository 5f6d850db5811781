// Every colour of the program, in one place: the workbench, the patterns of surfaces, and the colours that
// mean something.
//
// The player chooses one of two sets of colours with a meaning. The usual one follows Okabe and Ito's for
// colour-blind eyes ("Color Universal Design", 2008): blue against orange-red instead of green against red.
// The clear one differs more, above all in lightness, so that any two colours that can stand for different
// things in one place are different colours at a glance for protanopes, deuteranopes and tritanopes too. A
// meaning is never shown by colour alone: poles carry letters, live wires move, a forbidden place is hatched.
// tests/render/draw/palette_test.cpp computes the distances as eyes of each kind see them.
#pragma once

#include "render/draw/colour.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace trembler::render::palette {

// The workbench.
inline constexpr Colour paper = rgb(0xF4ECDD);
inline constexpr Colour paperLight = rgb(0xFBF7EE); ///< cards and tiles that lie on the paper
inline constexpr Colour paperShade = rgb(0xE7DBC5); ///< wells, tracks and pressed buttons
inline constexpr Colour grid = rgb(0xC4AE88);
inline constexpr Colour ink = rgb(0x2E2925);
inline constexpr Colour inkSoft = rgb(0x6B6157); ///< less important text; still 5:1 on paper
inline constexpr Colour shadow = {58, 40, 20, 92};

/// Colours with a meaning.
struct Meanings {
    // For the player's attention.
    Colour accent;     ///< buttons, links, selected objects, the first hand
    Colour accentDeep; ///< the same, pressed
    Colour goal;       ///< reached, right, allowed
    Colour warning;    ///< wrong, forbidden, dangerous
    Colour secondHand;
    // Physics.
    Colour northPole;
    Colour southPole;
    Colour live;      ///< current flows
    Colour liveCore;  ///< the moving charges on a live wire
    Colour deadWire;  ///< a wire without current
    Colour force;     ///< arrows of forces
    Colour contact;   ///< points of contact
    Colour sound;     ///< rings of sound
    Colour fieldLine; ///< magnetic field lines
};

enum class Choice : std::uint8_t { usual, clear };

/// By choice.
inline constexpr std::array<Meanings, 2> meanings{{
    {.accent = rgb(0x0B6E99),
     .accentDeep = rgb(0x084C6B),
     .goal = rgb(0x00805F),
     .warning = rgb(0xBC4B00),
     .secondHand = rgb(0xA8327A),
     .northPole = rgb(0xD5502B),
     .southPole = rgb(0x2F6FB5),
     .live = rgb(0xFFB000),
     .liveCore = rgb(0xFFF3C4),
     .deadWire = rgb(0x6E6558),
     .force = rgb(0x8A3FA0),
     .contact = rgb(0x1B1B1B),
     .sound = rgb(0x7A8F3C),
     .fieldLine = rgb(0x5C7C99)},
    {.accent = rgb(0x10365F),
     .accentDeep = rgb(0x0A2443),
     .goal = rgb(0x3A7D6E),
     .warning = rgb(0x8A2A00),
     .secondHand = rgb(0x9A6BE0),
     .northPole = rgb(0xE0451F),
     .southPole = rgb(0x1B4E9B),
     .live = rgb(0xFFC62E),
     .liveCore = rgb(0xFFF7D6),
     .deadWire = rgb(0x4F4A44),
     .force = rgb(0x75128F),
     .contact = rgb(0x000000),
     .sound = rgb(0xAA7E00),
     .fieldLine = rgb(0x6F8BA6)},
}};

namespace detail {
inline constinit Meanings inUse = meanings[0];
inline constinit Choice choice = Choice::usual;
} // namespace detail

/// Changes the colours of the names below. Window thread only; pictures that were kept must be drawn again.
inline void use(Choice choice) {
    detail::choice = choice;
    detail::inUse = meanings[static_cast<std::size_t>(choice)];
}
[[nodiscard]] inline Choice inUse() {
    return detail::choice;
}

// The colours of the present choice.
inline constinit Colour const& accent = detail::inUse.accent;
inline constinit Colour const& accentDeep = detail::inUse.accentDeep;
inline constinit Colour const& goal = detail::inUse.goal;
inline constinit Colour const& warning = detail::inUse.warning;
inline constinit Colour const& secondHand = detail::inUse.secondHand;
inline constinit Colour const& northPole = detail::inUse.northPole;
inline constinit Colour const& southPole = detail::inUse.southPole;
inline constinit Colour const& live = detail::inUse.live;
inline constinit Colour const& liveCore = detail::inUse.liveCore;
inline constinit Colour const& deadWire = detail::inUse.deadWire;
inline constinit Colour const& force = detail::inUse.force;
inline constinit Colour const& contact = detail::inUse.contact;
inline constinit Colour const& sound = detail::inUse.sound;
inline constinit Colour const& fieldLine = detail::inUse.fieldLine;

// Patterns.
inline constexpr Colour plain = rgb(0xD9CDB8);
inline constexpr Colour steel = rgb(0x9CA9B5);
inline constexpr Colour wood = rgb(0xC8945A);
inline constexpr Colour glass = {168, 220, 226, 70};
inline constexpr Colour rubber = rgb(0x45434A);
inline constexpr Colour stone = rgb(0xA79E92);
inline constexpr Colour plastic = rgb(0xE2B33C);
inline constexpr Colour copper = rgb(0xC9713D);
inline constexpr Colour water = {46, 138, 208, 165};

} // namespace trembler::render::palette
