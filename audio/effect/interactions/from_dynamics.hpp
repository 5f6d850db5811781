// (Sound <- Dynamics): bodies that collide, rub or roll make sounds.
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

/// Every impact excites both bodies, for as long as the resolver finds by Hertz's law. If surfaces slide or
/// roll on each other, their bumps make a noise of small impacts: a share of the friction, or of the load in
/// rolling, with as many bumps per second as the rougher surface has over the distance covered.
class SoundFromDynamics final
    : public Interaction<SoundFromDynamics, SoundRole,
                         Reads<Impacts, ContactPatches, Contacts, Shape, MadeOf, Acoustics, Sample, Mass,
                               Fixed, Friction, Position, Rotation, Velocity, AngularVelocity>> {
public:
    static constexpr ComponentText text{
        .name = "Sound <- Dynamics",
        .effect = "sound",
        .level = "",
        .work = "Excites both objects of every impact, by its impulse and for the contact time that follows "
                "from their hardness; excites objects that slide or roll on each other; plays the recordings "
                "of struck objects."};
    using Activation = NeedsAny<MadeOf, Acoustics, Sample>;

    void apply(Access& access);

private:
    void callStrikes(Access& access);
    void callRubs(Access& access);
};

} // namespace trembler
