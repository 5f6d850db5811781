#include "game/ui/play/lesson/lesson.hpp"

#include "render/window/gamepad.hpp"

#include <algorithm>

namespace trembler::ui {
namespace {

using Taught = TeachingStep::Kind;

/// Whether the step belongs to a run, or to building.
bool inRun(TeachingStep const& step) {
    return step.kind == Taught::grab || step.kind == Taught::cut;
}

bool samePair(std::string const& a, std::string const& b, TeachingStep const& step) {
    return (a == step.object && b == step.other) || (a == step.other && b == step.object);
}

} // namespace

InputDevice deviceOf(std::span<SDL_Event const> events, InputDevice before) {
    for (SDL_Event const& event : events) {
        if (event.type == SDL_MOUSEMOTION || event.type == SDL_MOUSEBUTTONDOWN) {
            before = InputDevice::mouse;
        } else if (event.type == SDL_KEYDOWN) {
            before = render::isPadKey(event.key.keysym.sym) ? InputDevice::pad : InputDevice::keys;
        }
    }
    return before;
}

bool Lesson::isDone(TeachingStep const& step) const {
    switch (step.kind) {
    case Taught::place: {
        auto const& placed = session_.placed();
        return std::any_of(placed.begin(), placed.end(), [&](PlacedPart const& part) {
            return length(part.placement.at - step.at) <= near;
        });
    }
    case Taught::wire: {
        auto const& wires = session_.wires();
        auto const nameOf = [&](LastingObject const& end) {
            ObjectId const object = session_.find(end);
            return object.valid() ? session_.world().store().nameOf(object) : std::string();
        };
        return std::any_of(wires.begin(), wires.end(), [&](LaidWire const& wire) {
            return samePair(nameOf(wire.a), nameOf(wire.b), step);
        });
    }
    case Taught::run:
        return session_.mode() != SessionMode::building;
    case Taught::grab:
    case Taught::cut: {
        auto const inputs = session_.inputs();
        return std::any_of(inputs.begin(), inputs.end(), [&](RecordedInput const& input) {
            return step.kind == Taught::grab
                       ? input.kind == PlayerInput::Kind::grab && input.object == step.object
                       : input.kind == PlayerInput::Kind::cut && samePair(input.object, input.other, step);
        });
    }
    }
    return true;
}

void Lesson::look(std::span<SDL_Event const> events, double seconds) {
    device_ = deviceOf(events, device_);
    auto const& steps = session_.level().teaching;
    if (over_) {
        return;
    }
    bool const building = session_.mode() == SessionMode::building;
    // While building a part may be taken away again. In a run nothing can be placed any more.
    for (std::size_t i = 0; building && i < std::min(done_, steps.size()); ++i) {
        bool const lost = !inRun(steps[i]) && steps[i].kind != Taught::run && !isDone(steps[i]);
        done_ = lost ? i : done_;
    }
    while (done_ < steps.size() && isDone(steps[done_])) {
        ++done_;
    }
    over_ = done_ == steps.size() || session_.solved();
    TeachingStep const* const now = step();
    age_ = now == shown_ ? age_ + seconds : 0;
    shown_ = now;
}

TeachingStep const* Lesson::step() const {
    auto const& steps = session_.level().teaching;
    if (over_ || done_ >= steps.size()) {
        return nullptr;
    }
    TeachingStep const& next = steps[done_];
    if (session_.mode() != SessionMode::building) {
        return inRun(next) ? &next : nullptr;
    }
    if (!inRun(next)) {
        return &next;
    }
    // It belongs to a run that has been ended: the step before it that began one is shown again.
    for (std::size_t i = done_; i-- > 0;) {
        if (steps[i].kind == Taught::run) {
            return &steps[i];
        }
    }
    return &next;
}

} // namespace trembler::ui
