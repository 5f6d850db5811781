#include "game/ui/tools/placing_tool.hpp"

#include "game/ui/shared/words.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::ui {
namespace {

Vec2 onGrid(Vec2 at, double step) {
    return {std::round(at.x / step) * step, std::round(at.y / step) * step};
}

} // namespace

double tidyAngle(double angle) {
    double const turned = std::remainder(angle, 2 * pi);
    double const whole = std::round(turned / fineTurnStep) * fineTurnStep;
    // Removes rounding errors, so that steps forth and back return exactly to the initial angle.
    return std::abs(turned - whole) < 1e-6 ? whole + 0.0 : turned;
}

Placement mirroredAcross(Placement placement, double x) {
    placement.at.x = 2 * x - placement.at.x;
    placement.angle = tidyAngle(-placement.angle);
    placement.flipped = !placement.flipped;
    return placement;
}

Placement const* PlacingTool::placementOf(int number) const {
    for (PlacedPart const& placed : session_.placed()) {
        if (placed.number == number) {
            return &placed.placement;
        }
    }
    return nullptr;
}

void PlacingTool::reset() {
    carried_.reset();
    selected_.reset();
    press_.reset();
}

bool PlacingTool::cancel() {
    bool const was = carried_.has_value() || press_.has_value();
    carried_.reset();
    press_.reset();
    return was;
}

void PlacingTool::take(std::string const& part, Pointer const& pointer) {
    carried_ = Carried{};
    carried_->landing = {part, pointer.world, 0, {}};
    carried_->takenAt = pointer.screen;
    carried_->dragging = true;
    selected_.reset();
    press_.reset();
    follow(pointer);
}

void PlacingTool::pickUp(int number, Vec2 grip, Pointer const& pointer) {
    Placement const* const placement = placementOf(number);
    if (placement == nullptr) {
        return;
    }
    carried_ = Carried{};
    carried_->number = number;
    carried_->landing = *placement;
    carried_->verdict = {true, {}};
    carried_->grip = grip;
    carried_->takenAt = pointer.screen;
    carried_->dragging = true;
    selected_ = number;
}

void PlacingTool::settle(Placement const& wanted, double reach) {
    carried_->landing = wanted;
    carried_->verdict = session_.check(wanted, carried_->number);
    if (carried_->verdict.ok || reach <= 0) {
        return;
    }
    // If the part does not fit here, try positions close by: the player points at objects, and the part would
    // touch their edges.
    constexpr int rings = 4;
    constexpr int directions = 8;
    for (int ring = 1; ring <= rings; ++ring) {
        for (int direction = 0; direction < directions; ++direction) {
            Placement beside = wanted;
            beside.at += rotated({reach * ring / rings, 0}, 2 * pi * direction / directions);
            if (session_.check(beside, carried_->number).ok) {
                carried_->landing = beside;
                carried_->verdict = {true, {}};
                return;
            }
        }
    }
}

void PlacingTool::follow(Pointer const& pointer) {
    Placement wanted = carried_->landing;
    if (carried_->turning) {
        Vec2 const arm = pointer.world - wanted.at;
        if (lengthSquared(arm) > 0) {
            double const step = pointer.free || pointer.fine ? fineTurnStep : turnStep;
            double const side = carried_->handleBelow ? -pi / 2 : pi / 2;
            wanted.angle = tidyAngle(std::round((std::atan2(arm.y, arm.x) - side) / step) * step);
        }
        settle(wanted, 0);
        return;
    }
    Vec2 const at = pointer.world + carried_->grip;
    wanted.at = pointer.free ? at : onGrid(at, pointer.fine ? gridStep / 5 : gridStep);
    settle(wanted, pointer.free ? 0 : 14 * pointer.pixel);
}

void PlacingTool::drop() {
    if (!carried_->verdict.ok) {
        if (carried_->turning) { // it turns back, and the reason beside it goes
            toasts_.add(words::capital(translated(carried_->verdict.why)), render::ToastKind::Trouble, 2.5);
            carried_.reset();
        } else { // it stays in the hand, which shows the reason, and follows the mouse until the next click
            toasts_.countTrouble();
        }
        return;
    }
    Placement const landing = carried_->landing;
    if (carried_->number) {
        moveTo(*carried_->number, landing);
        selected_ = carried_->number;
    } else {
        selected_ = session_.place(landing);
    }
    carried_.reset();
}

void PlacingTool::moveTo(int number, Placement const& wanted) {
    Placement const* const now = placementOf(number);
    bool const same = now != nullptr && now->at == wanted.at && now->angle == wanted.angle &&
                      now->flipped == wanted.flipped;
    if (now != nullptr && !same) {
        session_.move(number, wanted.at, wanted.angle, wanted.flipped);
    }
}

void PlacingTool::tryMove(int number, Placement const& wanted) {
    Verdict const verdict = session_.check(wanted, number);
    if (verdict.ok) {
        moveTo(number, wanted);
    } else {
        toasts_.add(words::capital(translated(verdict.why)), render::ToastKind::Trouble, 2.5);
    }
}

void PlacingTool::updateCarried(Pointer const& pointer) {
    if (pointer.wheel != 0 && !pointer.overCard) {
        turn(pointer.wheel > 0 ? 1 : -1, pointer.fine);
    }
    follow(pointer);
    bool const strayed = pointer.strayed(carried_->takenAt) > dragThreshold;
    if (carried_->dragging && (pointer.released || !pointer.held)) {
        carried_->dragging = false;
        bool const clicked = !strayed && !carried_->number && pointer.overToolbox;
        if (carried_->turning) {
            drop();
        } else if (pointer.overToolbox && !clicked) {
            putBack();
        } else if (!pointer.overCard) {
            drop();
        } // else it was a click on the tile: the part follows the mouse until the next click
        return;
    }
    if (!carried_->dragging && pointer.pressed) {
        if (pointer.overToolbox) {
            putBack();
        } else if (!pointer.overCard) {
            drop();
        }
    }
}

void PlacingTool::updateFree(Pointer const& pointer, std::optional<int> hovered, bool onHandle) {
    if (pointer.pressed && !pointer.overCard) {
        press_.reset();
        if (onHandle && selected_) {
            pickUp(*selected_, {}, pointer);
            if (carried_) {
                carried_->turning = true;
                Vec2 const arm = rotated(pointer.world - carried_->landing.at, -carried_->landing.angle);
                carried_->handleBelow = arm.y < 0;
            }
            return;
        }
        selected_ = hovered;
        if (Placement const* const placement = hovered ? placementOf(*hovered) : nullptr) {
            press_ = Press{*hovered, placement->at - pointer.world, pointer.screen};
        }
    }
    if (!pointer.held) {
        press_.reset();
    } else if (press_ && pointer.strayed(press_->at) > dragThreshold) {
        pickUp(press_->number, press_->grip, pointer);
        press_.reset();
        if (carried_) {
            follow(pointer);
        }
    }
}

void PlacingTool::update(Pointer const& pointer, std::optional<int> hovered, bool onHandle) {
    if (selected_ && placementOf(*selected_) == nullptr) {
        selected_.reset(); // its placement was undone
    }
    if (carried_ && carried_->number && placementOf(*carried_->number) == nullptr) {
        carried_.reset();
    }
    if (pointer.rightClicked && !pointer.overCard) {
        if (carried_) {
            cancel();
        } else if (hovered) {
            session_.putBack(*hovered);
        }
        return;
    }
    if (carried_) {
        updateCarried(pointer);
    } else {
        updateFree(pointer, hovered, onHandle);
    }
}

void PlacingTool::turn(int steps, bool fine) {
    double const by = steps * (fine ? fineTurnStep : turnStep);
    if (carried_) {
        Placement wanted = carried_->landing;
        wanted.angle = tidyAngle(wanted.angle + by);
        carried_->grip = rotated(carried_->grip, by);
        settle(wanted, 0);
        return;
    }
    Placement const* const placement = selected_ ? placementOf(*selected_) : nullptr;
    if (placement == nullptr) {
        return;
    }
    Placement wanted = *placement;
    wanted.angle = tidyAngle(wanted.angle + by);
    tryMove(*selected_, wanted);
}

void PlacingTool::flip() {
    if (carried_) {
        carried_->grip.x = -carried_->grip.x;
        settle(mirroredAcross(carried_->landing, carried_->landing.at.x), 0);
        return;
    }
    if (Placement const* const placement = selected_ ? placementOf(*selected_) : nullptr) {
        tryMove(*selected_, mirroredAcross(*placement, placement->at.x));
    }
}

void PlacingTool::nudge(Vec2 steps, bool fine) {
    Placement const* const placement = selected_ && !carried_ ? placementOf(*selected_) : nullptr;
    if (placement == nullptr) {
        return;
    }
    double const step = fine ? gridStep / 5 : gridStep;
    Placement wanted = *placement;
    wanted.at += steps * step;
    tryMove(*selected_, wanted);
}

void PlacingTool::putBack() {
    std::optional<int> const number = carried_ ? carried_->number : selected_;
    carried_.reset();
    press_.reset();
    selected_.reset();
    if (number) {
        session_.putBack(*number);
    }
}

} // namespace trembler::ui
