#include "physics/dynamics/interactions/from_player.hpp"

#include "physics/dynamics/core/point_pull.hpp"
#include "physics/dynamics/properties/shapes/mass_properties.hpp"

#include <numbers>

namespace trembler {

void DynamicsFromPlayer::apply(Access& access) {
    Hand const& first = access.read<Hand>();
    Hand const& second = access.read<SecondHand>().grip;
    bool const both = first.object == second.object;
    pull(access, first, both);
    pull(access, second, both);
}

void DynamicsFromPlayer::pull(Access& access, Hand const& hand, bool both) {
    ObjectId const held = hand.object;
    if (!held.valid()) {
        return;
    }
    Shape const* const shape = access.read<Shape>().find(held);
    Position const* const position = access.read<Position>().find(held);
    Rotation const* const rotation = access.read<Rotation>().find(held);
    Velocity const* const velocity = access.read<Velocity>().find(held);
    AngularVelocity const* const spin = access.read<AngularVelocity>().find(held);
    Mass const* const mass = access.read<Mass>().find(held);
    bool const movable = shape != nullptr && position != nullptr && rotation != nullptr &&
                         velocity != nullptr && spin != nullptr && mass != nullptr &&
                         !access.read<Fixed>().has(held);
    if (!movable || shape->pieces.empty()) {
        return;
    }
    MassProperties const spread = massPropertiesOf(*shape);
    Vec2 const point = position->value + rotated(hand.localPoint, rotation->angle);
    Vec2 const arm = rotated(hand.localPoint - spread.centre, rotation->angle);
    Vec2 const pointVelocity = velocity->value + spin->value * perpendicular(arm);
    Vec2 const wanted = criticallyDamped(frequency, hand.target - point, pointVelocity);
    double const gyration = spread.inertiaPerMass;
    Vec2 force = forceToAccelerate(wanted, arm, mass->value, gyration);
    auto const& hands = access.read<Hands>();
    double const strength = hands.empty() ? Hands{}.strength : hands.values().front().strength;
    if (strength <= 0) {
        return; // no hand: it must not slow down rotation either
    }
    if (double const size = length(force); size > strength) {
        force *= strength / size;
    }
    access.call(AddForceToPoint{held, point, force}, hand.event);
    // Two springs on one body are as stiff as one whose frequency is √2 times theirs.
    access.call(StateRate{held, both ? std::numbers::sqrt2 * frequency : frequency});
    access.call(AddTorque{held, -turnDamping * mass->value * gyration * spin->value}, hand.event);
}

} // namespace trembler
