#include "render/panels/icons.hpp"

#include "render/panels/icon_pen.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace trembler::render {

namespace {

constexpr float halfTurn = std::numbers::pi_v<float>; // in radians

/// An arrow down into a tray.
void save(IconPen const& pen) {
    pen.line(0.F, -0.85F, 0.F, 0.1F);
    pen.triangle(-0.5F, -0.05F, 0.5F, -0.05F, 0.F, 0.5F);
    pen.line(-0.8F, 0.35F, -0.8F, 0.8F);
    pen.line(-0.8F, 0.8F, 0.8F, 0.8F);
    pen.line(0.8F, 0.8F, 0.8F, 0.35F);
}

/// A sheet with a prompt: the text of a script.
void script(IconPen const& pen) {
    pen.frame(-0.85F, -0.7F, 0.85F, 0.7F, 0.2F);
    pen.line(-0.45F, -0.28F, -0.12F, 0.F);
    pen.line(-0.12F, 0.F, -0.45F, 0.28F);
    pen.line(0.05F, 0.3F, 0.48F, 0.3F);
}

/// Three quarters of a circle with an arrow's head; `side` is 1 clockwise and -1 anticlockwise.
void turn(IconPen const& pen, float side) {
    float const end = -0.5F * halfTurn + side * 0.15F;
    float const start = end - side * 1.55F * halfTurn;
    pen.arc(0, 0.08F, 0.66F, std::min(start, end), std::max(start, end));
    pen.triangle(side * 0.10F, -0.98F, side * 0.10F, -0.18F, side * 0.66F, -0.58F);
}

void gear(IconPen const& pen) {
    pen.circle(0, 0, 0.50F);
    for (int i = 0; i < 8; ++i) {
        float const angle = static_cast<float>(i) * 0.25F * halfTurn;
        float const c = std::cos(angle);
        float const s = std::sin(angle);
        pen.line(0.62F * c, 0.62F * s, 0.84F * c, 0.84F * s);
    }
}

void camera(IconPen const& pen) {
    pen.frame(-0.88F, -0.46F, 0.88F, 0.68F, 0.2F);
    pen.block(-0.34F, -0.72F, 0.34F, -0.40F);
    pen.circle(0, 0.11F, 0.30F);
}

void bulb(IconPen const& pen) {
    pen.arc(0, -0.2F, 0.56F, 0.75F * halfTurn, 2.25F * halfTurn);
    pen.line(-0.38F, 0.22F, -0.26F, 0.48F);
    pen.line(0.38F, 0.22F, 0.26F, 0.48F);
    pen.line(-0.24F, 0.56F, 0.24F, 0.56F);
    pen.line(-0.14F, 0.84F, 0.14F, 0.84F);
}

void question(IconPen const& pen) {
    pen.arc(0, -0.38F, 0.44F, -halfTurn, 0.42F * halfTurn);
    pen.line(0.12F, 0.06F, 0, 0.34F);
    pen.dot(0, 0.78F, 0.16F);
}

void eye(IconPen const& pen) {
    pen.arc(0, 0.56F, 1.06F, 1.18F * halfTurn, 1.82F * halfTurn);
    pen.arc(0, -0.56F, 1.06F, 0.18F * halfTurn, 0.82F * halfTurn);
    pen.dot(0, 0, 0.28F);
}

void magnet(IconPen const& pen) {
    pen.arc(0, -0.08F, 0.56F, halfTurn, 2 * halfTurn);
    pen.line(-0.56F, -0.08F, -0.56F, 0.36F);
    pen.line(0.56F, -0.08F, 0.56F, 0.36F);
    pen.block(-0.72F, 0.56F, -0.40F, 0.86F, 0.04F);
    pen.block(0.40F, 0.56F, 0.72F, 0.86F, 0.04F);
}

void bin(IconPen const& pen) {
    pen.line(-0.72F, -0.54F, 0.72F, -0.54F);
    pen.line(-0.22F, -0.78F, 0.22F, -0.78F);
    pen.line(-0.54F, -0.5F, -0.42F, 0.82F);
    pen.line(0.54F, -0.5F, 0.42F, 0.82F);
    pen.line(-0.42F, 0.82F, 0.42F, 0.82F);
    pen.line(0, -0.18F, 0, 0.48F);
}

/// An arrow that curves back; `side` is -1 for undo and 1 for redo.
void curvedArrow(IconPen const& pen, float side) {
    float const bend = 0.30F * -side;
    pen.line(side * 0.34F, -0.34F, bend, -0.34F);
    pen.line(side * 0.30F, 0.66F, bend, 0.66F);
    float const from = side < 0 ? -0.5F * halfTurn : 0.5F * halfTurn;
    pen.arc(bend, 0.16F, 0.50F, from, from + halfTurn);
    pen.triangle(side * 0.92F, -0.34F, side * 0.26F, -0.82F, side * 0.26F, 0.14F);
}

void scissors(IconPen const& pen) {
    pen.line(-0.52F, -0.80F, 0.36F, 0.42F);
    pen.line(0.52F, -0.80F, -0.36F, 0.42F);
    pen.circle(-0.46F, 0.62F, 0.26F);
    pen.circle(0.46F, 0.62F, 0.26F);
}

/// A ball on a floor, and the mark where they touch.
void contactIcon(IconPen const& pen) {
    pen.circle(0, -0.26F, 0.52F);
    pen.line(-0.86F, 0.40F, 0.86F, 0.40F);
    pen.triangle(0, 0.44F, -0.24F, 0.88F, 0.24F, 0.88F);
}

void gauge(IconPen const& pen) {
    pen.arc(0, 0.30F, 0.82F, halfTurn, 2 * halfTurn);
    pen.line(0, 0.30F, 0.40F, -0.16F);
    pen.line(-0.82F, 0.62F, 0.82F, 0.62F);
}

void corners(IconPen const& pen) {
    for (float const x : std::array{-1.F, 1.F}) {
        for (float const y : std::array{-1.F, 1.F}) {
            pen.line(x * 0.78F, y * 0.78F, x * 0.34F, y * 0.78F);
            pen.line(x * 0.78F, y * 0.78F, x * 0.78F, y * 0.34F);
        }
    }
    pen.dot(0, 0, 0.2F);
}

void lines(IconPen const& pen) {
    for (float const y : std::array{-0.56F, 0.F, 0.56F}) {
        pen.dot(-0.70F, y, 0.15F);
        pen.line(-0.34F, y, 0.76F, y);
    }
}

/// A drop of water.
void drop(IconPen const& pen) {
    pen.dot(0, 0.26F, 0.58F);
    pen.triangle(0, -0.92F, 0.52F, 0.02F, -0.52F, 0.02F);
}

/// A quaver.
void note(IconPen const& pen) {
    pen.dot(-0.26F, 0.56F, 0.32F);
    pen.line(0.02F, 0.56F, 0.02F, -0.78F);
    pen.line(0.02F, -0.78F, 0.56F, -0.30F);
}

/// Bricks in two courses.
void wall(IconPen const& pen) {
    pen.frame(-0.86F, -0.60F, 0.86F, 0.62F, 0.1F);
    pen.line(-0.80F, 0, 0.80F, 0);
    pen.line(0, -0.54F, 0, 0);
    pen.line(-0.42F, 0, -0.42F, 0.56F);
    pen.line(0.42F, 0, 0.42F, 0.56F);
}

/// A ball beside a box.
void solids(IconPen const& pen) {
    pen.dot(-0.40F, 0.36F, 0.44F);
    pen.block(0.06F, -0.70F, 0.84F, 0.80F);
}

void gridLines(IconPen const& pen) {
    for (float const x : std::array{-0.72F, 0.12F}) {
        for (float const y : std::array{-0.72F, 0.12F}) {
            pen.block(x, y, x + 0.60F, y + 0.60F);
        }
    }
}

void drawGroupSign(IconPen const& pen, Icon icon) {
    switch (icon) {
    case Icon::Drop:
        return drop(pen);
    case Icon::Note:
        return note(pen);
    case Icon::Wall:
        return wall(pen);
    case Icon::Solids:
        return solids(pen);
    case Icon::Grid:
        return gridLines(pen);
    default:
        return;
    }
}

void drawTransport(IconPen const& pen, Icon icon) {
    switch (icon) {
    case Icon::Slower:
        pen.triangle(0.90F, -0.68F, 0.90F, 0.68F, -0.02F, 0);
        pen.triangle(-0.02F, -0.68F, -0.02F, 0.68F, -0.94F, 0);
        break;
    case Icon::FastForward:
        pen.triangle(-0.90F, -0.68F, -0.90F, 0.68F, 0.02F, 0);
        pen.triangle(0.02F, -0.68F, 0.02F, 0.68F, 0.94F, 0);
        break;
    case Icon::Play:
        pen.triangle(-0.56F, -0.82F, -0.56F, 0.82F, 0.86F, 0);
        break;
    case Icon::Pause:
        pen.block(-0.62F, -0.76F, -0.16F, 0.76F);
        pen.block(0.16F, -0.76F, 0.62F, 0.76F);
        break;
    case Icon::Stop:
        pen.block(-0.68F, -0.68F, 0.68F, 0.68F);
        break;
    case Icon::Step:
        pen.triangle(-0.70F, -0.72F, -0.70F, 0.72F, 0.40F, 0);
        pen.block(0.42F, -0.72F, 0.74F, 0.72F, 0.06F);
        break;
    case Icon::Record:
        pen.dot(0, 0, 0.68F);
        break;
    case Icon::Reset:
        pen.triangle(0.78F, -0.72F, 0.78F, 0.72F, -0.40F, 0);
        pen.block(-0.74F, -0.72F, -0.42F, 0.72F, 0.06F);
        break;
    default:
        break;
    }
}

void drawSign(IconPen const& pen, Icon icon) {
    switch (icon) {
    case Icon::Menu:
        for (float const y : std::array{-0.55F, 0.F, 0.55F}) {
            pen.line(-0.72F, y, 0.72F, y);
        }
        break;
    case Icon::Back:
        pen.line(0.34F, -0.68F, -0.36F, 0);
        pen.line(-0.36F, 0, 0.34F, 0.68F);
        break;
    case Icon::Next:
        pen.line(-0.34F, -0.68F, 0.36F, 0);
        pen.line(0.36F, 0, -0.34F, 0.68F);
        break;
    case Icon::Tick:
        pen.line(-0.70F, 0.06F, -0.20F, 0.56F);
        pen.line(-0.20F, 0.56F, 0.74F, -0.52F);
        break;
    case Icon::Cross:
        pen.line(-0.56F, -0.56F, 0.56F, 0.56F);
        pen.line(-0.56F, 0.56F, 0.56F, -0.56F);
        break;
    case Icon::Plus:
        pen.line(-0.70F, 0, 0.70F, 0);
        pen.line(0, -0.70F, 0, 0.70F);
        break;
    case Icon::Flip:
        pen.triangle(-0.18F, -0.70F, -0.18F, 0.70F, -0.88F, 0.70F);
        pen.triangle(0.18F, -0.70F, 0.18F, 0.70F, 0.88F, 0.70F);
        break;
    case Icon::Bolt:
        pen.triangle(0.28F, -0.92F, -0.56F, 0.14F, 0.12F, 0.14F);
        pen.triangle(-0.28F, 0.92F, 0.56F, -0.14F, -0.12F, -0.14F);
        break;
    default:
        break;
    }
}

} // namespace

void drawIcon(ImDrawList& list, Icon icon, ImVec2 centre, float size, ImU32 colour) {
    IconPen const pen(list, centre, size, colour);
    switch (icon) {
    case Icon::Save:
        return save(pen);
    case Icon::Timeline: // a knob on a track, between marks
        pen.line(-0.9F, 0.3F, 0.9F, 0.3F);
        pen.dot(-0.15F, 0.3F, 0.36F);
        pen.line(-0.6F, -0.62F, -0.6F, -0.38F);
        pen.line(0.1F, -0.62F, 0.1F, -0.38F);
        pen.line(0.65F, -0.62F, 0.65F, -0.38F);
        break;
    case Icon::Curve: // a line that rises and falls, between axes
        pen.line(-0.85F, -0.85F, -0.85F, 0.8F);
        pen.line(-0.85F, 0.8F, 0.85F, 0.8F);
        pen.line(-0.5F, 0.35F, -0.1F, -0.4F);
        pen.line(-0.1F, -0.4F, 0.25F, 0.15F);
        pen.line(0.25F, 0.15F, 0.8F, -0.7F);
        break;
    case Icon::Repeat: // a section between two bars
        pen.line(-0.85F, -0.7F, -0.85F, 0.7F);
        pen.line(0.85F, -0.7F, 0.85F, 0.7F);
        pen.line(-0.45F, 0.F, 0.1F, 0.F);
        pen.triangle(0.05F, -0.42F, 0.05F, 0.42F, 0.6F, 0.F);
        break;
    case Icon::GoOn: // from a mark onwards
        pen.line(-0.75F, -0.8F, -0.75F, 0.8F);
        pen.triangle(-0.35F, -0.72F, -0.35F, 0.72F, 0.85F, 0.F);
        break;
    case Icon::Script:
        return script(pen);
    case Icon::Camera:
        return camera(pen);
    case Icon::TurnLeft:
        return turn(pen, -1);
    case Icon::TurnRight:
        return turn(pen, 1);
    case Icon::Remove:
        return bin(pen);
    case Icon::Hint:
        return bulb(pen);
    case Icon::Why:
        return question(pen);
    case Icon::Settings:
        return gear(pen);
    case Icon::Eye:
        return eye(pen);
    case Icon::Magnet:
        return magnet(pen);
    case Icon::Undo:
        return curvedArrow(pen, -1);
    case Icon::Redo:
        return curvedArrow(pen, 1);
    case Icon::List:
        return lines(pen);
    case Icon::Scissors:
        return scissors(pen);
    case Icon::Contact:
        return contactIcon(pen);
    case Icon::Gauge:
        return gauge(pen);
    case Icon::Fit:
        return corners(pen);
    default:
        drawTransport(pen, icon);
        drawSign(pen, icon);
        drawGroupSign(pen, icon);
    }
}

} // namespace trembler::render
