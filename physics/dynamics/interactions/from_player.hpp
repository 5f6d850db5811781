// The player's hand pulls with a force.
#pragma once

#include "physics/dynamics/calls.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "runtime/component/interaction.hpp"
#include "runtime/input/input_resolver.hpp"
#include "runtime/placement.hpp"

namespace trembler {

/// A damped spring from the held point to the hand.
class DynamicsFromPlayer final
    : public Interaction<DynamicsFromPlayer, DynamicsRole,
                         Reads<Hand, Position, Rotation, Velocity, AngularVelocity, Mass, Shape, Fixed>> {
public:
    static constexpr ComponentText text{
        .name = "Dynamics <- Player",
        .effect = "player",
        .level = "",
        .work = "Pulls the held point of the held object to the position of the hand, like a critically "
                "damped spring, and damps the object's rotation."};
    using Activation = NeedsAll<Shape>;

    static constexpr double frequency = 12; ///< rad/s, of the spring
    /// m/s². The greatest acceleration that the hand gives an object, light or heavy, independent of the
    /// world's gravity. So the hand can hold up any object in a world with less gravity.
    static constexpr double strongest = 490.5;
    static constexpr double turnDamping = 2; ///< 1/s

    void apply(Access& access);
};

} // namespace trembler
