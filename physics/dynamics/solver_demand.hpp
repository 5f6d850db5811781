// How finely a scene asks to be computed: what follows from its bodies, joints and contacts alone, never from
// a clock. The figures behind the automatic settings; docs/stability.md measures whether they suffice.
#pragma once

#include "physics/dynamics/bodies.hpp"
#include "physics/dynamics/contacts.hpp"
#include "physics/dynamics/joints.hpp"

namespace trembler {

/// What the joints of a scene ask for.
///
/// The frequency of the fastest of two motions of any jointed body, in rad/s. A body between taut joints
/// zig-zags with ω² = T l / I (T pull in N, l between its joints in m, I moment of inertia in kg m²; for a
/// rod this is the √(12 T / (m l)) of a chain's link). T is the weight that hangs on the joint: that of the
/// side that nothing else holds if the joint is all that ties it to the ground, the lesser side if nothing is
/// held, and all that is tied together where a loop leaves the share open. Springs and gears pull nothing
/// taut. Linear in the number of joints; in no particular order of objects.
[[nodiscard]] double zigZagFrequency(DynamicsColumns const& columns, BodyTable const& bodies,
                                     JointTable const& joints, double gravity);

/// The same for welds: ω² = W d / I, with the weight W at a distance d that a weld must keep from turning.
[[nodiscard]] double bendingFrequency(DynamicsColumns const& columns, BodyTable const& bodies,
                                      JointTable const& joints, double gravity);

/// What contacts ask for: of all bodies that touch, the greatest ratio of the mass that rests on a body to
/// its own. Weight goes from each body in equal shares to the moving ones that it touches farther down; what
/// touches the ground as well is held by that too, all of it by its share. 0 where nothing rests on anything.
[[nodiscard]] double loadRatio(DynamicsColumns const& columns, BodyTable const& bodies,
                               std::span<TouchingPair const> touching, Vec2 gravity);

/// Engine units per metre for the scene's shapes, a power of two from 4 to 64: half of the bodies that move
/// are then thicker than 0.4 units, some thirty times as thick as the gap that Box2D keeps between shapes.
[[nodiscard]] double scaleFor(DynamicsColumns const& columns);

/// The smallest of a few numbers of substeps, from 4 to 64, that is not below `wanted`: few, so that what
/// changes a little does not change the step all the time.
[[nodiscard]] int roundedSubsteps(double wanted);

} // namespace trembler
