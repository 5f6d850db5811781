// Joints break, and are destroyed when an object that they connected no longer exists.
#pragma once

#include "physics/dynamics/properties/motion_causes.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "runtime/component/interaction.hpp"
#include "runtime/population/calls.hpp"

namespace trembler {

class PopulationFromDynamics final
    : public Interaction<PopulationFromDynamics, PopulationRole, Reads<Joint, Shape, OverloadedJoints>> {
public:
    static constexpr ComponentText text{.name = "Population <- Dynamics",
                                        .effect = "dynamics",
                                        .level = "",
                                        .work = "Destroys every overloaded joint, and every joint of which "
                                                "an object, or a coupled joint, no longer exists."};
    using Activation = NeedsAll<Joint>;
    void apply(Access& access);
};

} // namespace trembler
