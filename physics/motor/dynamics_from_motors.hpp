// (Dynamics <- Electricity): motors with current turn, and generators that supply current resist turning.
#pragma once

#include "physics/dynamics/calls.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/motor/properties.hpp"
#include "runtime/component/interaction.hpp"
#include "runtime/placement.hpp"

namespace trembler {

class DynamicsFromElectricity final
    : public Interaction<DynamicsFromElectricity, DynamicsRole,
                         Reads<ElectricalState, ElectricMotor, AngularVelocity, Mass, Shape, Fixed>> {
public:
    static constexpr ComponentText text{.name = "Dynamics <- Electricity",
                                        .effect = "motor",
                                        .level = "",
                                        .work = "Applies the torque of every electric motor that is on, and "
                                                "the opposite torque to the object that bears the reaction."};
    using Activation = NeedsAll<ElectricMotor>;
    void apply(Access& access);
};

/// It reports no rate: the amount of the braking torque is constant, and a torque that would turn the rotor
/// back while it is held is reduced to the torque that stops it. So shorter steps would not follow it better.
class DynamicsFromGenerators final
    : public Interaction<DynamicsFromGenerators, DynamicsRole,
                         Reads<ElectricalState, Generator, AngularVelocity, Mass, Shape, Fixed>> {
public:
    static constexpr ComponentText text{.name = "Dynamics <- Generators",
                                        .effect = "motor",
                                        .level = "",
                                        .work = "Brakes every generator through which current flows."};
    using Activation = NeedsAll<Generator>;
    void apply(Access& access);
};

} // namespace trembler
