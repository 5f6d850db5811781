#include "game/ui/tools/hand_tool.hpp"

#include "game/ui/shared/texts.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/settings.hpp"
#include "physics/dynamics/properties/shape.hpp"

#include <utility>

namespace trembler::ui {
namespace {

/// Pressing this long without moving also grabs the object, s.
constexpr double holdTime = 0.25;
/// Distance within which a click hits a wire, pixels at UI scale 1.
constexpr double wireReach = 10;
char const* const& noHands = said("Your hands can move nothing in this level.");
constexpr double noHandsTime = 2.5; // s, for which that is shown

} // namespace

void HandTool::reset() {
    press_.reset();
    waiting_.clear();
    held_ = {};
    wire_ = {};
    cutting_ = false;
}

void HandTool::letGo() {
    press_.reset();
    if (held_.valid()) {
        waiting_.push_back({PlayerInput::Kind::release, held_, {}, target_, hand_});
        held_ = {};
    }
}

bool HandTool::movable(ObjectId object) const {
    World const& world = session_.world();
    return world.find<Shape>(object) != nullptr && world.find<Fixed>(object) == nullptr;
}

bool HandTool::handless() const {
    auto const* const hands = session_.world().store().findColumn<Hands>();
    return hands != nullptr && !hands->empty() && hands->values().front().strength <= 0;
}

void HandTool::grab(Press const& press) {
    held_ = press.object;
    target_ = sentTarget_ = press.at;
    lead_.begin(press.at);
    waiting_.push_back({PlayerInput::Kind::grab, press.object, {}, press.at, hand_});
}

void HandTool::cut(Pointer const& pointer) {
    wire_ = pointer.overCard ? render::Link{}
                             : render::pickWire(session_.world(), {pointer.world.x, pointer.world.y},
                                                wireReach * pointer.pixel);
    if (pointer.pressed && wire_.a.valid()) {
        waiting_.push_back({PlayerInput::Kind::cut, wire_.a, wire_.b, pointer.world});
        cut_ = std::exchange(wire_, {});
        cutting_ = pointer.fine; // with Shift the scissors stay in the hand
    }
}

std::optional<ObjectId> HandTool::update(Pointer const& pointer, ObjectId hovered, double seconds) {
    if (held_.valid() && !session_.world().store().alive(held_)) {
        held_ = {}; // the object was destroyed while it was held
    }
    if (cutting_) {
        cut(pointer);
        return {};
    }
    wire_ = {};
    if (pointer.pressed && !pointer.overCard) {
        press_ = Press{hovered, pointer.world, pointer.screen};
    }
    if (held_.valid()) {
        target_ = pointer.world;
        if (!pointer.held) {
            letGo();
        }
        return {};
    }
    if (!press_) {
        return {};
    }
    press_->seconds += seconds;
    bool const strayed = pointer.strayed(press_->screen) > dragThreshold;
    bool const lifted = !pointer.held;
    if (!lifted && movable(press_->object) && (strayed || press_->seconds > holdTime)) {
        if (handless()) {
            toasts_.add(noHands, render::ToastKind::Trouble, noHandsTime);
        } else {
            grab(*press_);
            target_ = pointer.world;
        }
        press_.reset();
        return {};
    }
    if (!lifted) {
        return {};
    }
    ObjectId const clicked = press_->object;
    press_.reset();
    return strayed ? std::nullopt : std::optional(clicked);
}

void HandTool::beforeStep() {
    for (PlayerInput const& input : waiting_) {
        session_.feed(input);
    }
    waiting_.clear();
    if (!held_.valid() || !session_.world().store().alive(held_)) {
        return;
    }
    Vec2 const target = lead_.ahead(target_);
    if (!(target == sentTarget_)) {
        session_.feed({PlayerInput::Kind::move, held_, {}, target, hand_});
        sentTarget_ = target;
    }
}

} // namespace trembler::ui
