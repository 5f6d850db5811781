// Changing how exactly a world is computed, by names, as recorded runs state it.
#pragma once

#include "runtime/level/recorded_change.hpp"
#include "runtime/world/world.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace trembler {

/// Makes a change count from the next frame of a world of this registry on. Between frames only. Throws
/// std::invalid_argument, saying what is wrong and what there is, if it names an unknown effect, level,
/// component, property or field, or a number that is out of range. Settings are numbers, whole or not, of
/// properties of the world.
void apply(Registry const& registry, World& world, RecordedChange const& change);

/// Whether it would change nothing.
[[nodiscard]] bool holds(Registry const& registry, World const& world, RecordedChange const& change);

/// What apply() would throw, for each change, or nothing where it would do it. Needs no running world.
[[nodiscard]] std::vector<std::optional<std::string>> faultsIn(Registry const& registry,
                                                               std::span<RecordedChange const> changes);

/// In a few words: "gravity: tree", "Buoyancy Resolver: every 4th frame", "gravity_law: opening_angle 0.5".
[[nodiscard]] std::string inWords(RecordedChange const& change);

/// The changes that make the one set of options into the other: detail levels and periods.
[[nodiscard]] std::vector<RecordedChange> differences(Registry const& registry, WorldOptions const& from,
                                                      WorldOptions const& to);

} // namespace trembler
