// The forces that pull at each joint.
#pragma once

#include "physics/dynamics/core/bodies.hpp"
#include "physics/dynamics/core/joints.hpp"
#include "physics/dynamics/core/loads.hpp"

#include <vector>

namespace trembler {

/// The load of a joint.
struct JointLoad {
    double mass = 0;    ///< kg, that the joint carries
    double pull = 0;    ///< N, of the forces that act on that mass
    Vec2 centre;        ///< m, centre of that mass; only if `alone`
    bool alone = false; ///< no other joint connects that mass to the rest
};

/// By slot of the joints. One walk over the graph of bodies and joints, in which all fixed bodies and the
/// world are one node: a joint that is a bridge of the graph (Tarjan 1974) carries everything beyond it, and
/// so the sum of the forces there. In a loop the shares of the joints are not determined; each is then
/// assumed to carry the sum of the magnitudes of all forces. `loads` by slot of the bodies.
[[nodiscard]] std::vector<JointLoad> jointLoads(DynamicsColumns const& columns, BodyTable const& bodies,
                                                JointTable const& joints, std::span<LoadSum const> loads);

} // namespace trembler
