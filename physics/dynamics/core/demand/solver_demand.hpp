// How finely a scene asks to be computed. It follows from its bodies, joints, contacts and the forces that
// act, whichever effects they come from; never from a clock. The figures behind the automatic settings;
// docs/measurements/stability.md measures whether they suffice.
#pragma once

#include "physics/dynamics/core/bodies.hpp"
#include "physics/dynamics/core/joints.hpp"
#include "physics/dynamics/core/loads.hpp"

namespace trembler {

/// The demand of a scene's joints.
struct JointDemand {
    /// rad/s, of the fastest zig-zag. A body between taut joints turns to and fro with ω² = T l / I (T pull
    /// in N, l between its joints in m, I moment of inertia in kg m²; for a rod this is the √(12 T / (m l))
    /// of a chain's link). T is the sum of the forces that pull at the joint: all forces on the side that
    /// nothing else holds if the joint is all that ties it to the ground, on the lighter side if nothing is
    /// held, and on all that is tied together where a loop leaves the share open. Springs and gears pull
    /// nothing taut.
    double zigZag = 0;
    /// rad/s: the same for welds, ω² = W d / I, with the load W at a distance d that a weld must keep from
    /// turning. Only an engine that solves joints one by one has such a motion.
    double bending = 0;
    /// The most hinges, welds and rigid distances that tie moving bodies together in one piece.
    std::size_t network = 0;
};

/// `loads` by slot of the bodies. About linear in the number of joints; the same for any order of objects.
[[nodiscard]] JointDemand jointDemand(DynamicsColumns const& columns, BodyTable const& bodies,
                                      JointTable const& joints, std::span<LoadSum const> loads);

/// Engine units per metre for the scene's shapes, a power of two from 4 to 64: half of the bodies that move
/// are then at least 0.4 units thick, forty times the skin that Box2D keeps around a shape. Where less than
/// twenty bodies move, whose gaps and overlaps add up to little, 0.06 units will do.
[[nodiscard]] double scaleFor(DynamicsColumns const& columns);

/// The smallest of a few numbers of substeps, from 1 to 64, that is not below `wanted`: few, so that small
/// changes of the scene do not change the step all the time.
[[nodiscard]] int roundedSubsteps(double wanted);

} // namespace trembler
