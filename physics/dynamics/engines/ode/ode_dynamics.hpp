// The Dynamics role implemented with ODE.
#pragma once

#include "physics/dynamics/core/dynamics_engine.hpp"

namespace trembler {

#ifdef TREMBLER_HAS_ODE
/// Makes an ODE world, which uses metres; `scale` is that of the collision routines.
[[nodiscard]] std::unique_ptr<Engine> makeOdeEngine(double scale);
#endif

inline constexpr DynamicsEngine odeDynamics{
    .text{.name = "ODE Dynamics",
          .effect = "dynamics",
          .level = "ode",
          .work =
              "Performs both collision detection and rigid body simulation, with the Open Dynamics Engine "
              "kept in the plane, in the world's number of substeps; applies the requested forces and "
              "impulses. Gears, pulleys and wheels are approximated.",
          .rank = 20},
#ifdef TREMBLER_HAS_ODE
    .make = makeOdeEngine
#else
    .make = nullptr,
    .missing =
        "this program was built without ODE; install libode-dev and build it again with TREMBLER_ODE=ON"
#endif
};

} // namespace trembler
