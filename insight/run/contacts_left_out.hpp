// Lets pairs of objects pass through each other, while everything else collides as before.
#pragma once

#include "runtime/world/world.hpp"

#include <span>
#include <utility>

namespace trembler::insight {

using ObjectPair = std::pair<ObjectId, ObjectId>;

/// Sets collision groups between two frames, or before the first, so that no object of a pair touches the
/// other one from the next frame on. All other pairs behave as before: an object of each pair gets a category
/// of its own, which only its partners leave out. `without` must hold all such pairs of the run so far, those
/// of earlier calls too. Throws std::invalid_argument if the categories, of which there are 16, do not
/// suffice.
void leaveOutContacts(World& world, std::span<ObjectPair const> without);

} // namespace trembler::insight
