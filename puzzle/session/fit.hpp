// Whether a part has room where a player wants to put it.
#pragma once

#include "runtime/level/model/level.hpp"
#include "runtime/level/model/part_library.hpp"
#include "runtime/world/world.hpp"

#include <optional>
#include <span>
#include <string>

namespace trembler {

/// How far, in m, two parts may overlap where they are placed. Above zero, as a player who makes two parts
/// touch cannot place them more exactly than this.
inline constexpr double allowedOverlap = 0.01;

/// Names what a part would overlap in the world as it stands, in words for the player; nothing if it has
/// room. Objects in `ignored`, for example the part itself while it is being moved, do not count.
[[nodiscard]] std::optional<std::string> whyItDoesNotFit(World const& world, PartLibrary const& parts,
                                                         Placement const& placement,
                                                         std::span<ObjectId const> ignored);

} // namespace trembler
