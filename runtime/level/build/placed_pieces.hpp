// The objects that a placed part becomes, before there is a world with them: to draw it, and to see whether
// it fits.
#pragma once

#include "runtime/level/model/level.hpp"
#include "runtime/level/model/part_library.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace trembler {

struct PlacedPiece {
    std::string name; ///< in the part; that of the part itself if it is one object
    /// In the world's frame, with Position and Rotation. References to objects in it are void.
    PropertySet properties;
    bool main = false;
};

/// The objects of a placement, joints left out. Empty if there is no such part, or if its pieces cannot be
/// made, see checkComposites().
[[nodiscard]] std::vector<PlacedPiece> placedPieces(PartLibrary const& library, Placement const& placement);
/// The joints of a placement, in the world's frame; empty if it has none or cannot be made. An object that
/// they refer to has the index that it has in placedPieces(), a joint one of the indices after those.
[[nodiscard]] std::vector<PropertySet> placedJoints(PartLibrary const& library, Placement const& placement);

/// The names of the objects that an entry becomes, as Origin::piece counts them.
struct EntryNames {
    std::vector<std::string> objects; ///< empty if they cannot be made
    std::size_t main = 0;             ///< the one to which the entry's own name refers
};
[[nodiscard]] EntryNames namesOf(PartLibrary const& library, LevelObject const& entry);

/// The entry of an object with that name that a placement becomes.
[[nodiscard]] LevelObject entryOf(Placement const& placement, std::string name);

} // namespace trembler
