#include "game/ui/play/mouse/field_mouse.hpp"

#include "physics/dynamics/properties/body.hpp"

namespace trembler::ui {

void FieldMouse::tookPart() {
    tookPart_ = true;
    leftOnPaper_ = false;
}

bool FieldMouse::update(Pointer const& pointer, Surroundings const& around, double seconds) {
    picking_.pointAt(pointer);
    if (pointer.pressed) {
        pressedAt_ = pointer.screen;
    }
    bool rebuilt = false;
    if (session_.mode() == SessionMode::building) {
        rebuilt = usePlacing(pointer, around.handle);
    } else {
        useHand(pointer, around, seconds);
    }
    tookPart_ = false;
    lookAround(pointer);
    return rebuilt;
}

bool FieldMouse::usePlacing(Pointer const& pointer, std::optional<Vec2> const& handle) {
    ObjectId const hovered = picking_.hovered();
    std::optional<int> const number = hovered.valid() ? session_.numberOf(hovered) : std::nullopt;
    bool const onHandle = handle && length(pointer.world - *handle) < handleReach * pointer.pixel;
    bool const wasCarrying = placing_.carried().has_value();
    auto const before = session_.placed().size();
    World const* const world = &session_.world();
    bool const ofWire = !tookPart_ && wires_.update(pointer, hovered);
    bool const ofGroup = ofWire || (!tookPart_ && !onHandle && group_.update(pointer, number));
    if (tookPart_) {
        group_.reset();
        wires_.reset();
    } else if (!ofGroup) {
        placing_.update(pointer, number, onHandle);
    }
    if (world != &session_.world() || before != session_.placed().size()) {
        return true;
    }
    if (number && pointer.twice && !pointer.overCard && !ofWire) {
        picking_.inspect(hovered);
    }
    bool const paper = !wasCarrying && !number && !onHandle && !ofGroup;
    if (pointer.pressed) {
        leftOnPaper_ = paper && !pointer.overCard;
    }
    if (pointer.released && leftOnPaper_) {
        leftOnPaper_ = false;
        if (pointer.strayed(pressedAt_) <= dragThreshold) {
            picking_.inspect(hovered);
        }
    }
    return false;
}

void FieldMouse::useHand(Pointer const& pointer, Surroundings const& around, double seconds) {
    if (wasSecond_ && !around.second) {
        second_.letGo();
        if (!pointer.held) {
            hand_.letGo();
        }
    }
    wasSecond_ = around.second;
    if (around.past && around.taken) {
        if (pointer.released && pointer.strayed(pressedAt_) <= dragThreshold) {
            picking_.inspect(picking_.hovered());
        }
        leftOnPaper_ = false;
        return;
    }
    if (around.past) {
        if (pointer.pressed) {
            leftOnPaper_ = !pointer.overCard;
        } else if (pointer.released && leftOnPaper_ && pointer.strayed(pressedAt_) <= dragThreshold) {
            picking_.inspect(picking_.hovered());
        }
        leftOnPaper_ = leftOnPaper_ && pointer.held;
        return;
    }
    HandTool& hand = around.second ? second_ : hand_;
    ObjectId const hovered = picking_.hovered();
    bool const free = hovered.valid() && session_.world().find<Fixed>(hovered) == nullptr;
    if (pointer.pressed) {
        leftOnPaper_ = !pointer.overCard && !hand_.cutting() && (!free || around.watching);
    }
    if (auto const clicked = hand.update(pointer, hovered, seconds)) {
        picking_.inspect(*clicked);
    }
    if (!pointer.held) {
        leftOnPaper_ = false;
    }
    if (pointer.rightClicked && hand_.cutting()) {
        hand_.setCutting(false);
    }
}

void FieldMouse::lookAround(Pointer const& pointer) {
    bool const carrying = placing_.carried().has_value() || group_.dragging();
    if (pointer.wheel != 0 && !pointer.overCard && !carrying) {
        view_.zoom(pointer.screen, pointer.wheel);
    }
    if (pointer.rightPressed) {
        rightOnPaper_ = !pointer.overCard;
    }
    bool const right = pointer.rightHeld && rightOnPaper_;
    bool const left = pointer.held && leftOnPaper_ && !carrying;
    if ((pointer.middleHeld && !pointer.overCard) || right || left) {
        view_.startPan();
    } else if (!pointer.middleHeld) {
        view_.stopPan();
    }
    view_.drag(pointer.moved);
}

} // namespace trembler::ui
