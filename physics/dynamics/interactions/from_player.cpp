#include "physics/dynamics/interactions/from_player.hpp"

#include "physics/dynamics/core/point_pull.hpp"
#include "physics/dynamics/properties/mass_properties.hpp"

namespace trembler {

void DynamicsFromPlayer::apply(Access& access) {
    Hand const& hand = access.read<Hand>();
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
    double const limit = strongest * mass->value;
    if (double const size = length(force); size > limit) {
        force *= limit / size;
    }
    access.call(AddForceToPoint{held, point, force}, hand.event);
    access.call(StateRate{held, frequency});
    access.call(AddTorque{held, -turnDamping * mass->value * gyration * spin->value}, hand.event);
}

} // namespace trembler
