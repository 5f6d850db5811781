// The player's hand pulls with a force.
#pragma once

#include "physics/dynamics/calls.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/settings.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "runtime/component/interaction.hpp"
#include "runtime/input/input_resolver.hpp"
#include "runtime/placement.hpp"

namespace trembler {

/// A damped spring from each held point to the hand that holds it.
class DynamicsFromPlayer final
    : public Interaction<
          DynamicsFromPlayer, DynamicsRole,
          Reads<Hand, SecondHand, Hands, Position, Rotation, Velocity, AngularVelocity, Mass, Shape, Fixed>> {
public:
    static constexpr ComponentText text{
        .name = "Dynamics <- Player",
        .effect = "player",
        .level = "",
        .work = "Pulls the held point of each held object to the position of the hand, like a critically "
                "damped spring with at most the strength of the world's hands, and damps the object's "
                "rotation."};
    using Activation = NeedsAll<Shape>;

    static constexpr double frequency = 12;  ///< rad/s, of the spring
    static constexpr double turnDamping = 2; ///< 1/s

    void apply(Access& access);

private:
    /// `both`: the other hand holds the same object.
    static void pull(Access& access, Hand const& hand, bool both);
};

} // namespace trembler
