#include "game/ui/tools/wire_tool.hpp"

#include "game/ui/shared/words.hpp"
#include "physics/electricity/properties/electrical.hpp"

#include <utility>

namespace trembler::ui {
namespace {

/// Distance within which a click hits a wire, pixels at UI scale 1.
constexpr double bladeReach = 10;
constexpr double reasonTime = 2.5; // s

} // namespace

void WireTool::reset() {
    laying_ = cutting_ = false;
    from_ = {};
    to_ = {};
    why_.clear();
    wire_ = {};
}

void WireTool::switchLaying() {
    bool const next = !laying_;
    reset();
    laying_ = next;
}

void WireTool::switchCutting() {
    bool const next = !cutting_;
    reset();
    cutting_ = next;
}

bool WireTool::cancel() {
    if (from().valid()) {
        from_ = {};
        to_ = {};
        why_.clear();
        return true;
    }
    bool const was = laying_ || cutting_;
    reset();
    return was;
}

void WireTool::cut(Pointer const& pointer) {
    wire_ = pointer.overCard ? render::Link{}
                             : render::pickWire(session_.world(), {pointer.world.x, pointer.world.y},
                                                bladeReach * pointer.pixel);
    if (!pointer.pressed || !wire_.a.valid()) {
        return;
    }
    render::Link const wire = std::exchange(wire_, {});
    if (!session_.takeWire(wire.a, wire.b)) {
        toasts_.add(words::wireOfLevel, render::ToastKind::Trouble, reasonTime);
    }
}

void WireTool::finish() {
    if (session_.layWire(from(), to_)) {
        from_ = {};
        if (session_.wiresLeft() <= 0) {
            reset();
        }
    } else {
        toasts_.add(translated(why_), render::ToastKind::Trouble, reasonTime); // and can end elsewhere
    }
    to_ = {};
    why_.clear();
}

bool WireTool::conducts(ObjectId object) const {
    return session_.world().find<Conductor>(object) != nullptr;
}

std::string WireTool::whyNotTo(ObjectId object) const {
    // In the words in which it is refused as a beginning.
    return conducts(object) ? session_.checkWire(from(), object).why
                            : words::conductsNot(session_.world().store().nameOf(object));
}

bool WireTool::update(Pointer const& pointer, ObjectId hovered) {
    if (cutting_) {
        if (pointer.rightClicked) {
            cancel();
        } else {
            cut(pointer);
        }
        return true;
    }
    if (!laying_) {
        return false;
    }
    if (pointer.rightClicked) {
        cancel();
        return true;
    }
    ObjectId const begin = from();
    why_.clear();
    to_ = {};
    if (!begin.valid()) {
        bool const begins = hovered.valid() && conducts(hovered);
        if (hovered.valid() && !begins) {
            why_ = words::conductsNot(session_.world().store().nameOf(hovered));
        }
        if (!pointer.pressed || pointer.overCard) {
            return !pointer.overCard;
        }
        if (begins) {
            from_ = session_.lasting(hovered);
            pressedAt_ = pointer.screen;
            dragging_ = !pointer.released;
        } else if (!why_.empty()) {
            toasts_.add(translated(why_), render::ToastKind::Trouble, reasonTime);
        }
        return hovered.valid(); // the paper can be dragged
    }
    if (hovered.valid() && hovered != begin) {
        to_ = hovered;
        why_ = whyNotTo(hovered);
    }
    bool const clicked = pointer.pressed && !pointer.overCard;
    if (clicked && hovered == begin) { // it can be dragged from there once more
        pressedAt_ = pointer.screen;
        dragging_ = true;
    }
    // Only the release of a press at the beginning: one click gives one answer.
    bool const letGo = pointer.released && std::exchange(dragging_, false);
    bool const dragged = letGo && pointer.strayed(pressedAt_) > dragThreshold;
    if (dragged || clicked) {
        if (to_.valid()) {
            finish();
        } else if (!hovered.valid()) {
            from_ = {}; // onto the paper: nothing is laid
        }
    }
    return true;
}

} // namespace trembler::ui
