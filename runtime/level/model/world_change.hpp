// Changing how exactly a world is computed, by names, as recorded runs state it.
#pragma once

#include "runtime/level/model/change_fault.hpp"
#include "runtime/level/model/recorded_change.hpp"
#include "runtime/world/world.hpp"

#include <string>
#include <vector>

namespace trembler {

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
