#include "runtime/input/input_resolver.hpp"

namespace trembler {

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
        case PlayerInput::Kind::grab: {
            Position const* const position = access.read<Position>().find(input.object);
            if (position == nullptr) {
                break; // destroyed since the player aimed
            }
            Rotation const* const rotation = access.read<Rotation>().find(input.object);
            double const angle = rotation == nullptr ? 0 : rotation->angle;
            Hand& hand = access.provide<Hand>();
            hand.object = input.object;
            hand.localPoint = rotated(input.at - position->value, -angle);
            hand.target = input.at;
            hand.event = access.event("grabbed", {input.object}, {});
            break;
        }
        case PlayerInput::Kind::move:
            if (access.provided<Hand>().object.valid()) {
                access.provide<Hand>().target = input.at;
            }
            break;
        case PlayerInput::Kind::release:
            if (ObjectId const held = access.provided<Hand>().object; held.valid()) {
                access.event("released", {held}, {access.provided<Hand>().event});
                access.provide<Hand>() = {};
            }
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
