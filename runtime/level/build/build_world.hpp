// From a level to a world that can be stepped.
#pragma once

#include "runtime/level/build/placing.hpp"
#include "runtime/level/model/level.hpp"
#include "runtime/level/model/part_library.hpp"
#include "runtime/world/world.hpp"

#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace trembler {

/// A world, and the objects made from each entry of the lists that it was built from.
struct BuiltLevel {
    std::unique_ptr<World> world;  ///< started, at frame 0
    std::vector<ObjectId> objects; ///< by index in LevelFile::objects; of a composite, its main piece
    std::vector<ObjectId> joints;  ///< by index in LevelFile::joints
    std::vector<ObjectId>
        placements; ///< by index in the placements that were given; of a composite, its main piece
    /// All objects of an entry or a placement that is made from a composite part, by Origin::piece; by index
    /// in LevelFile::objects and in the placements.
    std::map<std::size_t, std::vector<ObjectId>> objectPieces;
    std::map<std::size_t, std::vector<ObjectId>> placementPieces;
    /// The objects that are connected from the start, the lower id first; ascending.
    std::vector<std::pair<ObjectId, ObjectId>> connections;
};

/// Builds and starts the world of a level with the player's placements. Throws InputError, with the places in
/// the file, for all faults: unknown parts, references to missing objects, properties that break a rule of
/// the registry, connections that no effect or more than one can make, placements that are not allowed.
/// `registry` must outlive the world. Detail levels in the options override the levels that the level file
/// states. `wires` are the wires that the player has laid, by the names of their ends.
///
/// Objects are created in canonical order: "world", the level's objects by name, its joints by name, then the
/// placements in their own canonical order; a composite becomes its pieces and joints, see PartExpander. The
/// name of an object that is made from a composite refers to its main piece. So neither the order of entries
/// in the file nor the order of placing ever matters. Each object's Origin is the inverse of BuiltLevel.
[[nodiscard]] BuiltLevel buildLevel(Registry const& registry, LevelFile const& level,
                                    PartLibrary const& library, std::span<Placement const> placements = {},
                                    WorldOptions options = {}, std::span<LevelConnection const> wires = {});

/// The same, for callers that find objects by the names that the level states.
[[nodiscard]] std::unique_ptr<World> buildWorld(Registry const& registry, LevelFile const& level,
                                                PartLibrary const& library,
                                                std::span<Placement const> placements = {},
                                                WorldOptions options = {});

} // namespace trembler
