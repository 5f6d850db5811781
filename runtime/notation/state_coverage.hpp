// Lists the data that the state hash covers, and the data that it leaves out, with reasons.
#pragma once

#include "runtime/world/registry.hpp"

#include <string>
#include <vector>

namespace trembler {

struct CoverageLine {
    std::string what;
    std::string covered; ///< "hashed", "derived" or "left out"
    std::string reason;  ///< empty for hashed data
};

/// All data that a world with these components keeps between frames, one line each.
[[nodiscard]] std::vector<CoverageLine> stateCoverage(Registry const& registry);

} // namespace trembler
