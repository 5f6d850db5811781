// How finely a scene must be computed: the basis of the automatic settings. It depends on the scene's bodies,
// joints, contacts and forces of any effect, never on a clock. docs/measurements/stability.md measures
// whether it suffices.
#pragma once

#include "physics/dynamics/core/bodies.hpp"
#include "physics/dynamics/core/joints.hpp"
#include "physics/dynamics/core/loads.hpp"

namespace trembler {

/// The demand of a scene's joints.
struct JointDemand {
    /// rad/s, of the fastest zig-zag. A body between taut joints oscillates with ω² = T l / I (T pull in N, l
    /// distance of its joints in m, I moment of inertia in kg m²; for a rod this is the √(12 T / (m l)) of a
    /// chain's link). T is the sum of the forces that pull at the joint: all forces on the side away from the
    /// ground if the joint alone connects it to the ground, on the lighter side if neither side is held, and
    /// on all connected bodies in a loop, where the joints' shares are not determined. Springs and gears make
    /// no joint taut.
    double zigZag = 0;
    /// rad/s: the same for welds, ω² = W d / I, with the load W at a distance d that a weld must keep from
    /// turning. This motion occurs only in engines that solve joints one by one.
    double bending = 0;
    /// The greatest number of hinges, welds and rigid distances that connect movable bodies to one piece.
    std::size_t network = 0;
};

/// `loads` by slot of the bodies. About linear in the number of joints; the same for any order of objects.
[[nodiscard]] JointDemand jointDemand(DynamicsColumns const& columns, BodyTable const& bodies,
                                      JointTable const& joints, std::span<LoadSum const> loads);

/// Engine units per metre for the scene's shapes, a power of two from 4 to 64: half of the movable bodies are
/// then at least 0.4 units thick, forty times the skin that Box2D keeps around a shape. With fewer than
/// twenty movable bodies, whose gaps and overlaps add up to little, 0.06 units suffice.
[[nodiscard]] double scaleFor(DynamicsColumns const& columns);

/// The smallest of a few numbers of substeps, from 1 to 64, that is not below `wanted`. There are few, so
/// that small changes of the scene rarely change the step.
[[nodiscard]] int roundedSubsteps(double wanted);

} // namespace trembler
