// (Electricity <- Rotation): generators that turn fast enough supply current.
#pragma once

#include "physics/dynamics/properties/motion_causes.hpp"
#include "physics/electricity/calls.hpp"
#include "physics/electricity/properties/graph.hpp"
#include "physics/motor/properties.hpp"
#include "runtime/component/interaction.hpp"
#include "runtime/placement.hpp"

namespace trembler {

/// Reads from the graph whether a generator is connected, so it needs no memory.
class ElectricityFromRotation final
    : public Interaction<ElectricityFromRotation, ElectricityRole,
                         Reads<Generator, AngularVelocity, ElectricityGraph, MotionCauses>> {
public:
    static constexpr ComponentText text{.name = "Electricity <- Rotation",
                                        .effect = "motor",
                                        .level = "",
                                        .work =
                                            "Connects every generator to its source when it turns fast "
                                            "enough, and disconnects it below nine tenths of that speed."};
    using Activation = NeedsAll<Generator>;
    static constexpr double lettingGo =
        0.9; ///< share of the speed, so that it does not switch on and off at the limit
    void apply(Access& access);
};

} // namespace trembler
