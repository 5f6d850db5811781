// The conditions for valid joints.
#pragma once

#include "physics/dynamics/properties/joint.hpp"

#include <optional>
#include <string>

namespace trembler {

/// The data of a joint's objects that its validity depends on.
struct JointPartners {
    bool aIsBody = false; ///< has a place and a valid shape
    bool bIsBody = false;
    bool aFixed = false;
    bool bFixed = false;
    Joint const* jointA = nullptr; ///< the joint that a gear's joint_a names, if it is a joint
    Joint const* jointB = nullptr;
};

/// The fault of the joint and the expected condition, in words; nothing if it is valid.
[[nodiscard]] std::optional<std::string> faultIn(Joint const& joint, JointPartners const& partners);

} // namespace trembler
