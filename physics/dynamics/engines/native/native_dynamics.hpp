// The Dynamics role implemented with the engine of this project.
#pragma once

#include "physics/dynamics/core/dynamics_engine.hpp"

namespace trembler {

/// Makes a world of the native engine. It computes in metres, whatever the scale.
[[nodiscard]] std::unique_ptr<Engine> makeNativeEngine(double scale);

inline constexpr DynamicsEngine nativeDynamics{
    .text{.name = "Native Dynamics",
          .effect = "dynamics",
          .level = "native",
          .work = "Performs both collision detection and rigid body simulation, in double precision, with "
                  "substeps for each group of touching bodies; applies the requested forces and impulses."},
    .make = makeNativeEngine};

} // namespace trembler
