// Whether a part fits in the place where a player wants to put it.
#pragma once

#include "runtime/level/model/level.hpp"
#include "runtime/level/model/part_library.hpp"
#include "runtime/world/world.hpp"

#include <optional>
#include <span>
#include <string>

namespace trembler {

/// How far, in m, two placed parts may overlap. Above zero, because a player who makes two parts touch cannot
/// place them more exactly.
inline constexpr double allowedOverlap = 0.01;

/// Names the object that a part would overlap in the present world, in words for the player; nothing if the
/// part fits; of a composite, all of its pieces must. Two contact rings, such as those of cogs, may overlap
/// if springs and nothing else hold both. Objects in `ignored`, for example those of the part itself while it
/// is being moved, do not count.
[[nodiscard]] std::optional<std::string> whyItDoesNotFit(World const& world, PartLibrary const& parts,
                                                         Placement const& placement,
                                                         std::span<ObjectId const> ignored);

} // namespace trembler
