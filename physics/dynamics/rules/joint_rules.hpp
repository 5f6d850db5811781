// Which joints are sound.
#pragma once

#include "physics/dynamics/properties/joint.hpp"

#include <optional>
#include <string>

namespace trembler {

/// The objects that a joint ties together, as far as its soundness depends on them.
struct JointPartners {
    bool aIsBody = false; ///< has a place and a sound shape
    bool bIsBody = false;
    bool aFixed = false;
    bool bFixed = false;
    Joint const* jointA = nullptr; ///< the object that a gear's joint_a names, if that is a joint
    Joint const* jointB = nullptr;
};

/// The fault of the joint and what was expected, in words; nothing if it is sound.
[[nodiscard]] std::optional<std::string> faultIn(Joint const& joint, JointPartners const& partners);

} // namespace trembler
