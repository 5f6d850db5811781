// Dynamics computed by Box2D.
#pragma once

#include "physics/dynamics/core/dynamics_resolver.hpp"

namespace trembler {

/// Makes a Box2D world whose unit of length is 1/`scale` m.
[[nodiscard]] std::unique_ptr<Engine> makeBox2dEngine(double scale);

class Box2dDynamics final : public DynamicsResolver<Box2dDynamics> {
public:
    static constexpr ComponentText text{
        .name = "Dynamics",
        .effect = "dynamics",
        .level = "box2d",
        .work = "Performs both collision detection and rigid body simulation, with "
                "Box2D, in the world's number of substeps; carries out the forces and "
                "impulses that were asked for."};
    static constexpr EngineMaker engineMaker = makeBox2dEngine;
};

} // namespace trembler
