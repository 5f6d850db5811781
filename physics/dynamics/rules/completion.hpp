// The properties that Dynamics adds to new objects.
#pragma once

#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/material.hpp"
#include "runtime/component/completion.hpp"
#include "runtime/object/without.hpp"
#include "runtime/placement.hpp"

namespace trembler {

struct MatterCompletion final
    : Completion<MatterCompletion, Reads<MadeOf, Without>, Adds<Density, Friction, Restitution>> {
    static constexpr CompletionText text{.name = "Matter",
                                         .work = "Gives an object the density, friction and restitution of "
                                                 "its material, unless it is stated to be without them."};
    using Activation = NeedsAll<MadeOf>;
    static void complete(Access& access);
};

/// An invalid shape (one that a rule refuses) has no mass, so none is added.
struct BodyCompletion final : Completion<BodyCompletion, Reads<Shape, Fixed, Liquid, Density>,
                                         Adds<Rotation, Velocity, AngularVelocity, Mass>> {
    static constexpr CompletionText text{
        .name = "Body",
        .work = "Gives an object with a shape a rotation and a mass: its density (1000 kg/m³ if not stated) "
                "times its area times the depth of the world. Unless it is fixed or a liquid, it also gets a "
                "velocity and an angular velocity. Objects that never move have a mass too: gravity needs "
                "it, and the attenuation of sound by walls."};
    using Activation = NeedsAll<Shape>;
    static void complete(Access& access);
};

} // namespace trembler
