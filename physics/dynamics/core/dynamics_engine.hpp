// An engine as a detail level of Dynamics.
#pragma once

#include "physics/dynamics/core/engine.hpp"
#include "runtime/component/info.hpp"

namespace trembler {

/// The value with which a DynamicsResolver is registered; a constant, as it must outlive every registry.
struct DynamicsEngine {
    ComponentText text;
    EngineMaker make = nullptr;
    std::string_view
        missing{}; ///< why this program was built without it, and what to install; "" if it has it
};

} // namespace trembler
