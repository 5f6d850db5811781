// What a recorded change, the components panel and a time budget may change while a level runs.
#pragma once

#include "runtime/level/model/recorded_change.hpp"
#include "runtime/world/world.hpp"

#include <map>
#include <optional>
#include <string>

namespace trembler {

/// Why a change is refused, and what may be changed instead.
struct ChangeFault {
    std::string message;
    std::string expected;
};

// What may be changed while a level runs, by a recorded solution, the components panel and a time budget
// alike, is how exactly it is computed, never its physics:
//  - a setting: a number of a property of the world whose description states an AccuracyRange, within that;
//  - a period: that of a component which declares a longest one, up to that (Registration::longestPeriod);
//  - a detail level: one that is faithful to what the scene states (Registration::faithful), or that the
//    level file itself states.

/// What is wrong with a change in any world of this registry; nothing if it may be made.
[[nodiscard]] std::optional<ChangeFault> faultIn(Registry const& registry, RecordedChange const& change);
/// In this world as it is now. What is other physics in a world stays so for as long as it runs.
[[nodiscard]] std::optional<ChangeFault> faultIn(Registry const& registry, World const& world,
                                                 RecordedChange const& change);

/// The same where other detail levels are stated than those that the world has now.
[[nodiscard]] std::optional<ChangeFault> faultIn(Registry const& registry, World const& world,
                                                 std::map<std::string, std::string> const& stated,
                                                 RecordedChange const& change);
[[nodiscard]] std::string inWords(ChangeFault const& fault);

} // namespace trembler
