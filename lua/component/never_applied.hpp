// Why a script is applied to nothing, for its author: it is no error, but seldom what was meant.
#pragma once

#include "lua/binding/script.hpp"
#include "runtime/world/world.hpp"

#include <string>

namespace trembler::lua {

struct NeverApplied {
    /// How many of the conditions hold: of several worlds, the one that comes nearest says most.
    int held = 0;
    std::string why; ///< "no object has 'Wind'", without a full stop
};

/// Which of the conditions under which a script is applied does not hold in a started world in which it has
/// not been applied. The script must be one of the world's registry.
[[nodiscard]] NeverApplied whyNeverApplied(Script const& script, World const& world);

} // namespace trembler::lua
