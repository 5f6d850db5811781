#include "runtime/input/input_resolver.hpp"

namespace trembler {

void InputResolver::useHand(Access& access, PlayerInput const& input) {
    if (input.hand > 1) {
        return;
    }
    bool const isSecond = input.hand == 1;
    Hand hand = isSecond ? second_ : access.provided<Hand>();
    switch (input.kind) {
    case PlayerInput::Kind::grab: {
        Position const* const position = access.read<Position>().find(input.object);
        if (position == nullptr) {
            return; // destroyed since the player aimed
        }
        Rotation const* const rotation = access.read<Rotation>().find(input.object);
        double const angle = rotation == nullptr ? 0 : rotation->angle;
        hand.object = input.object;
        hand.localPoint = rotated(input.at - position->value, -angle);
        hand.target = input.at;
        hand.event = access.event("grabbed", {input.object}, {});
        break;
    }
    case PlayerInput::Kind::move:
        if (!hand.object.valid()) {
            return;
        }
        hand.target = input.at;
        break;
    case PlayerInput::Kind::release:
        if (!hand.object.valid()) {
            return;
        }
        access.event("released", {hand.object}, {hand.event});
        hand = {};
        break;
    case PlayerInput::Kind::cut:
    case PlayerInput::Kind::remove:
        return;
    }
    if (isSecond) {
        second_ = hand;
        access.provide<SecondHand>().grip = hand;
    } else {
        access.provide<Hand>() = hand;
    }
}

void InputResolver::advance(Access& access) {
    if (commandsStand_) {
        access.provide<PlayerCommands>() = {};
        commandsStand_ = false;
    }
    access.forCalls<PlayerInput>([&](PlayerInput const& input, CallOrigin const&) {
        if (!isFinite(input.at)) {
            return;
        }
        switch (input.kind) {
        case PlayerInput::Kind::grab:
        case PlayerInput::Kind::move:
        case PlayerInput::Kind::release:
            useHand(access, input);
            break;
        case PlayerInput::Kind::cut: {
            EventId const event = access.event("cut", {input.object, input.other}, {});
            access.provide<PlayerCommands>().cuts.push_back({input.object, input.other, event});
            commandsStand_ = true;
            break;
        }
        case PlayerInput::Kind::remove: {
            EventId const event = access.event("removed", {input.object}, {});
            access.provide<PlayerCommands>().removals.push_back({input.object, event});
            commandsStand_ = true;
            break;
        }
        }
    });
}

} // namespace trembler
