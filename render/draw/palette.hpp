// Every colour of the program, in one place: the workbench, the patterns of surfaces, and the colours that
// mean something.
//
// Colours with a meaning follow Okabe and Ito's set for colour-blind eyes ("Color Universal Design", 2008):
// blue against orange-red instead of green against red, and different in lightness besides. A meaning is
// never shown by colour alone: poles carry letters, live wires move, a forbidden place is hatched.
// tests/render checks the distances as the three kinds of colour-blind eyes see them.
#pragma once

#include "render/draw/colour.hpp"

namespace trembler::render::palette {

// The workbench.
inline constexpr Colour paper = rgb(0xF4ECDD);
inline constexpr Colour paperLight = rgb(0xFBF7EE); ///< cards and tiles that lie on the paper
inline constexpr Colour paperShade = rgb(0xE7DBC5); ///< wells, tracks and things pressed
inline constexpr Colour grid = rgb(0xC4AE88);
inline constexpr Colour ink = rgb(0x2E2925);
inline constexpr Colour inkSoft = rgb(0x6B6157); ///< second-rank text; still 5:1 on paper
inline constexpr Colour shadow = {58, 40, 20, 92};

// For the player's attention.
inline constexpr Colour accent = rgb(0x0B6E99);     ///< buttons, links, selected objects
inline constexpr Colour accentDeep = rgb(0x084C6B); ///< the same, pressed
inline constexpr Colour goal = rgb(0x00805F);       ///< reached, right, allowed
inline constexpr Colour warning = rgb(0xBC4B00);    ///< wrong, forbidden, dangerous

// Physics.
inline constexpr Colour northPole = rgb(0xD5502B);
inline constexpr Colour southPole = rgb(0x2F6FB5);
inline constexpr Colour live = rgb(0xFFB000);      ///< current flows
inline constexpr Colour liveCore = rgb(0xFFF3C4);  ///< the moving charges on a live wire
inline constexpr Colour deadWire = rgb(0x6E6558);  ///< a wire without current
inline constexpr Colour force = rgb(0x8A3FA0);     ///< arrows of forces
inline constexpr Colour contact = rgb(0x1B1B1B);   ///< points of contact
inline constexpr Colour sound = rgb(0x7A8F3C);     ///< rings of sound
inline constexpr Colour fieldLine = rgb(0x5C7C99); ///< magnetic field lines

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
