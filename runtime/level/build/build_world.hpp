// From a level to a world that can be stepped.
#pragma once

#include "runtime/level/build/placing.hpp"
#include "runtime/level/model/level.hpp"
#include "runtime/level/model/part_library.hpp"
#include "runtime/world/world.hpp"

namespace trembler {

/// Whether two objects of a complete world overlap. Shapes are physics, so it is handed in.
using OverlapTest = std::function<bool(Store const&, ObjectId, ObjectId)>;

/// Builds and starts the world of a level with what the player placed. Throws InputError, with the places in
/// the file, for whatever is wrong: unknown parts, references to objects that are not there, properties that
/// break a rule of the registry, connections that no effect, or more than one, takes, placements that are not
/// allowed. `registry` must outlive the world. A detail level that the options name goes before the level's
/// own.
///
/// Objects are created in canonical order: "world", the level's objects by name, its joints by name, then the
/// placements in their own canonical order. So neither the order of entries in the file nor the order of
/// placing ever matters.
///
/// With an `overlap` test, a placement must not overlap anything that was there before it.
[[nodiscard]] std::unique_ptr<World> buildWorld(Registry const& registry, LevelFile const& level,
                                                PartLibrary const& library,
                                                std::span<Placement const> placements = {},
                                                WorldOptions options = {}, OverlapTest const& overlap = {});

/// The part's properties, those of the entry in their stead, and the taken-away ones left out.
[[nodiscard]] PropertySet effectiveProperties(PropertySet const& part, PropertySet const& own);
/// The keys of those that it is stated not to have, by itself or, where it says nothing, by its part;
/// ascending.
[[nodiscard]] std::vector<std::string> statedAbsent(PropertySet const& part, PropertySet const& own);

} // namespace trembler
