// Which entries of a level the names in joints and connections belong to.
#pragma once

#include "puzzle/data/game_data.hpp"
#include "puzzle/edit/document/command.hpp"

#include <string>
#include <unordered_map>

namespace trembler::edit {

/// Finds the entry that a reference belongs to: "door" for "door coil", if the part that "door" is made from
/// has a piece or joint "coil". The parts decide, not the letters of the names: beside a "door" with a piece
/// "left wheel" there may be an object "door left". A part that does not exist has no pieces. It answers
/// about the level as it was when this was made. For objects of the world: EditedWorld::entryOf().
class ReferenceOwners {
public:
    ReferenceOwners(GameData const& data, Json const& level);

    /// The name of the object or joint itself, else of the object of which it is a piece. The reference
    /// itself if there is none. Of several entries with the same name inside, the first in the file.
    [[nodiscard]] std::string of(std::string const& reference) const;
    /// Whether names contain a reference, or the entry that it belongs to.
    template <class Names>
    [[nodiscard]] bool among(Names const& names, std::string const& reference) const {
        return names.contains(reference) || names.contains(of(reference));
    }

private:
    std::unordered_map<std::string, std::string> owners_; // by all names of an entry; only looked up
};

} // namespace trembler::edit
