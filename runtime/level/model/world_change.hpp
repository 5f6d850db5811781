// Applies recorded changes of how exactly a world is computed.
#pragma once

#include "runtime/level/model/change_fault.hpp"
#include "runtime/level/model/recorded_change.hpp"
#include "runtime/world/world.hpp"

#include <string>
#include <vector>

namespace trembler {

/// Applies a change from the next frame of a world of this registry on. Between frames only. Throws
/// std::invalid_argument, with the fault and the accepted changes, if faultIn() finds a fault.
void apply(Registry const& registry, World& world, RecordedChange const& change);

/// Whether the world already has the values of the change.
[[nodiscard]] bool holds(Registry const& registry, World const& world, RecordedChange const& change);

/// In words: "gravity: tree", "Buoyancy Resolver: every 4th frame", "gravity_law: opening_angle 0.5".
[[nodiscard]] std::string inWords(RecordedChange const& change);

/// The changes of detail levels and periods that turn `from` into the other options.
[[nodiscard]] std::vector<RecordedChange> differences(Registry const& registry, WorldOptions const& from,
                                                      WorldOptions const& to);

} // namespace trembler
