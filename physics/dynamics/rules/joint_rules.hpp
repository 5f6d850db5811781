// Which joints are sound.
#pragma once

#include "physics/dynamics/properties/joint.hpp"

#include <optional>
#include <string>

namespace trembler {

/// What a joint ties together, as far as its soundness is concerned.
struct JointPartners {
    bool aIsBody = false; ///< has a place and a sound shape
    bool bIsBody = false;
    bool aFixed = false;
    bool bFixed = false;
    Joint const* jointA = nullptr; ///< what a gear's joint_a names, if that is a joint
    Joint const* jointB = nullptr;
};

/// What is wrong with the joint and what was expected, in words; nothing if it is sound.
[[nodiscard]] std::optional<std::string> faultIn(Joint const& joint, JointPartners const& partners);

} // namespace trembler
