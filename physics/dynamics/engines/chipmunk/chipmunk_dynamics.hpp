// The Dynamics role implemented with Chipmunk.
#pragma once

#include "physics/dynamics/core/dynamics_engine.hpp"

namespace trembler {

#ifdef TREMBLER_HAS_CHIPMUNK
/// Makes a Chipmunk space, which uses metres; `scale` is ignored.
[[nodiscard]] std::unique_ptr<Engine> makeChipmunkEngine(double scale);
#endif

inline constexpr DynamicsEngine chipmunkDynamics{
    .text{.name = "Chipmunk Dynamics",
          .effect = "dynamics",
          .level = "chipmunk",
          .work =
              "Performs both collision detection and rigid body simulation, with Chipmunk, in the world's "
              "number of substeps; applies the requested forces and impulses.",
          .rank = 10},
#ifdef TREMBLER_HAS_CHIPMUNK
    .make = makeChipmunkEngine
#else
    .make = nullptr,
    .missing = "this program was built without Chipmunk; install libchipmunk-dev and build it again with "
               "TREMBLER_CHIPMUNK=ON"
#endif
};

} // namespace trembler
