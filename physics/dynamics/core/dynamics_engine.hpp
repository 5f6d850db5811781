// An engine as a detail level of Dynamics.
#pragma once

#include "physics/dynamics/core/engine.hpp"
#include "runtime/component/info.hpp"

namespace trembler {

/// The value that a DynamicsResolver is registered with: a constant, as it must outlive every registry.
struct DynamicsEngine {
    ComponentText text;
    EngineMaker make = nullptr;
    std::string_view missing{}; ///< why this program was built without it, and what helps; "" if it is there
};

} // namespace trembler
