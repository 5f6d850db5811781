// The objects that an entry of a level becomes in the world: one, or the pieces of a composite part.
#pragma once

#include "puzzle/data/game_data.hpp"
#include "puzzle/edit/document/command.hpp"
#include "runtime/level/property/property_set.hpp"

#include <string>
#include <vector>

namespace trembler::edit {

/// The properties of each object that an entry becomes, in the world's frame, joints left out. Empty if the
/// entry cannot be read, or its part is none.
[[nodiscard]] std::vector<PropertySet> piecesOf(GameData const& data, Json const& entry);
/// Whether the entry is made from a part of several pieces.
[[nodiscard]] bool isComposite(GameData const& data, Json const& entry);

} // namespace trembler::edit
