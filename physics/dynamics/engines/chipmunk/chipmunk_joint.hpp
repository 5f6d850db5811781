// A joint as a constraint that Chipmunk's solver iterates.
#pragma once

#include "physics/dynamics/engines/substepped/joint_rows.hpp"

#include <chipmunk/chipmunk.h>
#include <chipmunk/chipmunk_structs.h>

namespace trembler {

struct ChipmunkJoint : cpConstraint {
    /// `first` and `second` are the two bodies that Chipmunk connects by the constraint; `all` also includes
    /// those of coupled joints.
    ChipmunkJoint(cpBody* first, cpBody* second, JointRows joint, std::vector<cpBody*> all, bool collide);

    JointRows rows;
    std::vector<cpBody*> bodies; ///< of rows.slots()
};

} // namespace trembler
