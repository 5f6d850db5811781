// An engine as a detail level of Dynamics.
#pragma once

#include "physics/dynamics/core/engine.hpp"
#include "runtime/component/info.hpp"

namespace trembler {

/// What a DynamicsResolver is registered with. A constant: it outlives every registry.
struct DynamicsEngine {
    ComponentText text;
    EngineMaker make = nullptr;
    std::string_view missing{}; ///< why this program was built without it, and what helps; "" if it is there
};

} // namespace trembler
