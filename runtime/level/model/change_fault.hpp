// Which changes a recording, the components panel and a time budget may make while a level runs.
#pragma once

#include "runtime/level/model/recorded_change.hpp"
#include "runtime/world/world.hpp"

#include <map>
#include <optional>
#include <string>

namespace trembler {

/// Why a change is refused, and which changes are accepted.
struct ChangeFault {
    std::string message;
    std::string expected;
};

// While a level runs, a recorded solution, the components panel and a time budget may change only how exactly
// it is computed, never its physics. They may change:
//  - a setting: a number of a property of the world, within the AccuracyRange that its description states;
//  - a period of a component, up to the longest one that it declares (Registration::longestPeriod);
//  - a detail level, to one that computes the scene's physics (Registration::faithful) or that the level file
//    itself states.

/// Why no world of this registry allows the change; nothing if a world may allow it.
[[nodiscard]] std::optional<ChangeFault> faultIn(Registry const& registry, RecordedChange const& change);
/// Why this world does not allow the change at present. A detail level that is other physics in a world stays
/// so while it runs.
[[nodiscard]] std::optional<ChangeFault> faultIn(Registry const& registry, World const& world,
                                                 RecordedChange const& change);

/// The same with `stated` in place of the world's present detail levels.
[[nodiscard]] std::optional<ChangeFault> faultIn(Registry const& registry, World const& world,
                                                 std::map<std::string, std::string> const& stated,
                                                 RecordedChange const& change);
[[nodiscard]] std::string inWords(ChangeFault const& fault);

} // namespace trembler
