// (Sound <- Dynamics): bodies that hit, rub or roll are heard.
#pragma once

#include "audio/effect/calls.hpp"
#include "audio/effect/properties/acoustics.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/contacts.hpp"
#include "physics/dynamics/properties/impacts.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/material.hpp"
#include "runtime/component/interaction.hpp"
#include "runtime/placement.hpp"

namespace trembler {

/// Every impact excites both bodies, for as long as Hertz says that they touch. Where surfaces slide or roll
/// on each other, their bumps are a noise of small impacts: a share of the friction, or of the load that
/// rolls, with as many bumps per second as the rougher of the two has in the way that it covers.
class SoundFromDynamics final
    : public Interaction<SoundFromDynamics, SoundRole,
                         Reads<Impacts, ContactPatches, Contacts, Shape, MadeOf, Acoustics, Sample, Mass,
                               Fixed, Friction, Position, Rotation, Velocity, AngularVelocity>> {
public:
    static constexpr ComponentText text{.name = "Sound <- Dynamics",
                                        .effect = "sound",
                                        .level = "",
                                        .work = "Strikes both objects of every impact, with its impulse and "
                                                "for the time that their hardness keeps "
                                                "them in touch; rubs those that slide or roll on each other; "
                                                "plays the recordings of struck objects."};
    using Activation = NeedsAny<MadeOf, Acoustics, Sample>;

    void apply(Access& access);

private:
    void callStrikes(Access& access);
    void callRubs(Access& access);
};

} // namespace trembler
