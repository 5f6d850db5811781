// Changing how exactly a world is computed, by names, as recorded runs state it.
#pragma once

#include "runtime/level/model/recorded_change.hpp"
#include "runtime/world/world.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

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

/// Makes a change count from the next frame of a world of this registry on. Between frames only. Throws
/// std::invalid_argument, saying what is wrong and what may be changed, if faultIn() finds anything.
void apply(Registry const& registry, World& world, RecordedChange const& change);

/// Whether it would change nothing.
[[nodiscard]] bool holds(Registry const& registry, World const& world, RecordedChange const& change);

/// In a few words: "gravity: tree", "Buoyancy Resolver: every 4th frame", "gravity_law: opening_angle 0.5".
[[nodiscard]] std::string inWords(RecordedChange const& change);

/// The changes that make the one set of options into the other: detail levels and periods.
[[nodiscard]] std::vector<RecordedChange> differences(Registry const& registry, WorldOptions const& from,
                                                      WorldOptions const& to);

} // namespace trembler
