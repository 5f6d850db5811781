// (Electricity <- Rotation): generators that turn fast enough supply current.
#pragma once

#include "physics/dynamics/properties/motion_causes.hpp"
#include "physics/electricity/calls.hpp"
#include "physics/electricity/properties/graph.hpp"
#include "physics/motor/properties.hpp"
#include "runtime/component/interaction.hpp"
#include "runtime/placement.hpp"

namespace trembler {

/// Whether it has connected one at present is read from the graph, so it has no memory of its own that could
/// go wrong.
class ElectricityFromRotation final
    : public Interaction<ElectricityFromRotation, ElectricityRole,
                         Reads<Generator, AngularVelocity, ElectricityGraph, MotionCauses>> {
public:
    static constexpr ComponentText text{.name = "Electricity <- Rotation",
                                        .effect = "motor",
                                        .level = "",
                                        .work =
                                            "Connects every generator that turns fast enough to its source, "
                                            "and disconnects it when it turns a tenth slower than that."};
    using Activation = NeedsAll<Generator>;
    static constexpr double lettingGo = 0.9; ///< of the speed: so that it does not flicker on the border
    void apply(Access& access);
};

} // namespace trembler
