#include "game/ui/play/whatif/what_if_tool.hpp"

#include "game/ui/tools/placing_tool.hpp"
#include "render/scene/facts/pick.hpp"
#include "runtime/placement.hpp"

namespace trembler::ui {
namespace {

// Pixels at UI scale 1.
constexpr double reachOfHand = 6;
constexpr double reachOfBlades = 10;
constexpr double fineShare = 0.2; // of a step

} // namespace

World const& WhatIfTool::world() const {
    World const* const other = view_.world();
    return other != nullptr ? *other : timeline_.world();
}

void WhatIfTool::reset() {
    drag_.reset();
    chosen_.clear();
    wire_ = {};
    cutting_ = false;
    giveCardKeys(false);
}

bool WhatIfTool::update(Pointer const& pointer, bool pulling) {
    wire_ = {};
    if (!view_.atMoment()) {
        drag_.reset();
        cutting_ = false;
        if (!view_.active()) {
            chosen_.clear();
            giveCardKeys(false);
        }
        return false;
    }
    render::Point const at{pointer.world.x, pointer.world.y};
    if (cutting_) {
        if (!pointer.overCard) {
            wire_ = render::pickWire(world(), at, reachOfBlades * pointer.pixel);
        }
        if (pointer.pressed && wire_.a.valid()) {
            Store const& store = world().store();
            view_.change({.kind = insight::Change::Kind::cut,
                          .object = store.nameOf(wire_.a),
                          .other = store.nameOf(wire_.b)});
            cutting_ = pointer.fine;
        } else if (pointer.rightClicked) {
            cutting_ = false;
        }
        return pointer.held || pointer.released;
    }
    if (pointer.pressed && !pointer.overCard) {
        giveCardKeys(false);
        grip(pointer, pulling);
    }
    if (!drag_) {
        return false;
    }
    drag_->moved = drag_->moved || pointer.strayed(drag_->pressedAt) > dragThreshold;
    if (drag_->moved) {
        drag_->at = pointer.world - drag_->grip;
    }
    if (!pointer.held) {
        Drag const done = *std::exchange(drag_, std::nullopt);
        if (done.moved && done.pull) {
            view_.change({.kind = insight::Change::Kind::grab,
                          .object = done.object,
                          .at = done.from,
                          .to = done.at + done.grip});
        } else if (done.moved) {
            put(done.object, done.at, done.angle);
        }
        return true;
    }
    return true;
}

void WhatIfTool::grip(Pointer const& pointer, bool pulling) {
    ObjectId const object =
        render::pick(world(), {pointer.world.x, pointer.world.y}, reachOfHand * pointer.pixel);
    Position const* const place = world().find<Position>(object);
    chosen_.clear();
    if (place == nullptr) {
        return;
    }
    Rotation const* const rotation = world().find<Rotation>(object);
    chosen_ = world().store().nameOf(object);
    drag_ = Drag{.object = chosen_,
                 .grip = pointer.world - place->value,
                 .at = place->value,
                 .angle = rotation == nullptr ? 0 : rotation->angle,
                 .from = pointer.world,
                 .pull = pulling,
                 .pressedAt = pointer.screen};
}

void WhatIfTool::put(std::string const& object, Vec2 at, double angle) {
    view_.change({.kind = insight::Change::Kind::place, .object = object, .at = at, .angle = angle});
}

void WhatIfTool::turn(int steps, bool fine) {
    double const step = steps * (fine ? fineTurnStep : turnStep);
    if (drag_) {
        drag_->angle += step;
        drag_->moved = true;
        return;
    }
    if (auto const now = placeOfChosen()) {
        put(chosen_, now->at, now->angle + step);
    }
}

void WhatIfTool::nudge(Vec2 steps, bool fine) {
    if (auto const now = placeOfChosen()) {
        double const step = gridStep * (fine ? fineShare : 1);
        put(chosen_, now->at + step * steps, now->angle);
    }
}

std::optional<WhatIfTool::Place> WhatIfTool::placeOfChosen() const {
    for (insight::Change const& change : view_.whatIf().changes) {
        if (change.kind == insight::Change::Kind::place && change.object == chosen_) {
            return Place{change.at, change.angle}; // which may not have been computed yet
        }
    }
    ObjectId const object = world().store().find(chosen_);
    Position const* const place = world().find<Position>(object);
    Rotation const* const rotation = world().find<Rotation>(object);
    if (!view_.atMoment() || place == nullptr) {
        return std::nullopt;
    }
    return Place{place->value, rotation == nullptr ? 0 : rotation->angle};
}

void WhatIfTool::remove() {
    if (view_.atMoment() && !chosen_.empty()) {
        view_.change({.kind = insight::Change::Kind::remove, .object = std::exchange(chosen_, {})});
        drag_.reset();
    }
}

} // namespace trembler::ui
