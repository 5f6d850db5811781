// The mouse as input of the tools: its position in pixels and in metres, and whether a card lies under it.
#pragma once

#include "render/draw/geometry.hpp"
#include "runtime/math/vec2.hpp"

namespace trembler::ui {

/// Distance, in pixels at UI scale 1, that a pressed mouse may move before a click becomes a drag.
inline constexpr double dragThreshold = 5;

struct Pointer {
    render::Point screen; ///< pixels
    Vec2 world;           ///< m
    double pixel = 0.01;  ///< m per pixel at UI scale 1
    double uiScale = 1;
    bool overCard = false;    ///< a card lies under it
    bool overToolbox = false; ///< and that card is the toolbox
    bool pressed = false;     ///< left button, in this picture
    bool released = false;
    bool held = false;
    bool twice = false;        ///< second press of a double click
    bool inside = true;        ///< over the window, or pressed there and still held
    render::Point moved;       ///< pixels, in this picture
    bool rightPressed = false; ///< right button, in this picture
    bool rightHeld = false;
    bool rightClicked = false; ///< pressed and released without a drag
    bool middleHeld = false;
    double wheel = 0;  ///< notches
    bool fine = false; ///< Shift: small steps
    bool free = false; ///< Ctrl or Alt: no snapping to the grid

    /// Pixels at UI scale 1 between the mouse and another place on the screen.
    [[nodiscard]] double strayed(render::Point from) const { return render::length(screen - from) / uiScale; }
};

} // namespace trembler::ui
