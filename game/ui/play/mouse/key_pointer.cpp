#include "game/ui/play/mouse/key_pointer.hpp"

#include "game/ui/tools/placing_tool.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trembler::ui {
namespace {

constexpr double beforeRepeat = 0.3; // s
constexpr double perRepeat = 0.05;   // s

} // namespace

void KeyPointer::move(Vec2 steps, bool fine, Pointer const& mouse, render::Camera const& camera) {
    double const step = fine ? gridStep / 5 : gridStep;
    if (!active_) {
        active_ = true;
        at_ = mouse.inside && !mouse.overCard ? mouse.world : Vec2{camera.centre.x, camera.centre.y};
        at_ = {std::round(at_.x / step) * step, std::round(at_.y / step) * step};
    }
    at_ += steps * step;
    render::Point const low = camera.toWorld({0, static_cast<double>(camera.viewport.height)});
    render::Point const high = camera.toWorld({static_cast<double>(camera.viewport.width), 0});
    at_ = {std::clamp(at_.x, low.x, high.x), std::clamp(at_.y, low.y, high.y)};
}

void KeyPointer::holdDirection(Vec2 direction, double seconds, bool fine, Pointer const& mouse,
                               render::Camera const& camera) {
    if (lengthSquared(direction) == 0) {
        directionHeld_ = 0;
        return;
    }
    // The key's own event made the first step.
    double const before = std::max(directionHeld_ - beforeRepeat, 0.0);
    directionHeld_ += std::clamp(seconds, 0.0, 0.25);
    double const after = std::max(directionHeld_ - beforeRepeat, 0.0);
    double const steps = std::floor(after / perRepeat) - std::floor(before / perRepeat);
    if (steps > 0) {
        move(direction * steps, fine, mouse, camera);
    }
}

Pointer KeyPointer::instead(Pointer const& mouse, render::Camera const& camera, bool held, bool ours) {
    bool const moved = mouse.moved.x != 0 || mouse.moved.y != 0;
    if (moved || mouse.pressed || mouse.rightPressed || mouse.wheel != 0) {
        active_ = false;
    }
    bool const before = held_;
    bool const wasDown = std::exchange(keyDown_, held);
    bool const began = held && !wasDown && ours;
    held_ = active_ && held && (before || began);
    if (!active_) {
        return mouse;
    }
    Pointer pointer = mouse;
    pointer.world = at_;
    pointer.screen = camera.toScreen({at_.x, at_.y});
    pointer.overCard = pointer.overToolbox = false;
    pointer.inside = true;
    pointer.moved = {};
    pointer.pressed = held_ && !before;
    pointer.released = !held_ && before;
    pointer.held = held_;
    pointer.twice = pointer.rightPressed = pointer.rightHeld = pointer.rightClicked = false;
    pointer.middleHeld = false;
    pointer.free = false;
    return pointer;
}

} // namespace trembler::ui
