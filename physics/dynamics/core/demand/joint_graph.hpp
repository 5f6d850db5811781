// Which forces pull at which joint.
#pragma once

#include "physics/dynamics/core/bodies.hpp"
#include "physics/dynamics/core/joints.hpp"
#include "physics/dynamics/core/loads.hpp"

#include <vector>

namespace trembler {

/// The load of a joint.
struct JointLoad {
    double mass = 0;    ///< kg, that hangs on it
    double pull = 0;    ///< N, of the forces that act on that mass
    Vec2 centre;        ///< m, where that mass is; only if `alone`
    bool alone = false; ///< nothing else ties that mass to the rest
};

/// By slot of the joints. One walk over the graph of bodies and joints, all fixed bodies and the world being
/// one node of it: a joint that is a bridge of the graph (Tarjan 1974) carries everything beyond it, and so
/// the sum of the forces there. Where a loop leaves the share open, all of the forces may pull, and none
/// against another. `loads` by slot of the bodies.
[[nodiscard]] std::vector<JointLoad> jointLoads(DynamicsColumns const& columns, BodyTable const& bodies,
                                                JointTable const& joints, std::span<LoadSum const> loads);

} // namespace trembler
