// The Dynamics role implemented with Box2D.
#pragma once

#include "physics/dynamics/core/dynamics_engine.hpp"

namespace trembler {

/// Makes a Box2D world whose unit of length is 1/`scale` m.
[[nodiscard]] std::unique_ptr<Engine> makeBox2dEngine(double scale);

inline constexpr DynamicsEngine box2dDynamics{
    .text{.name = "Dynamics",
          .effect = "dynamics",
          .level = "box2d",
          .work = "Performs both collision detection and rigid body simulation, with "
                  "Box2D, in the world's number of substeps; applies the requested forces and impulses."},
    .make = makeBox2dEngine};

} // namespace trembler
