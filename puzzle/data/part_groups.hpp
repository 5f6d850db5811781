// The groups of a part: as its file states them, or else as they follow from its properties.
#pragma once

#include "runtime/level/model/part_library.hpp"

#include <string>
#include <vector>

namespace trembler {

/// At least one, in the order of PartGroup. They follow from what the part and all its pieces have:
/// - electricity: a source, its return, a device, a fuse, a generator, or copper, of which contacts are made;
/// - magnets: a magnet or an electromagnet that is not there to make a sound;
/// - mechanics: joints by which pieces move, unless they only move a contact or a magnet;
/// - water: a liquid, or something so light that it floats high or rises;
/// - sound: a stated sound, or a sound sensor;
/// - mods: scripts;
/// - solids: one loose body that has no further function;
/// - structures: anything else that is fixed.
/// So a new part is in the right place without being listed anywhere. Empty for a part that does not exist.
[[nodiscard]] std::vector<PartGroup> groupsOf(PartLibrary const& parts, std::string const& part);

} // namespace trembler
