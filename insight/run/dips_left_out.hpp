// Lets liquids not act on some objects, while everything else dips into them as before.
#pragma once

#include "runtime/world/world.hpp"

#include <span>
#include <utility>

namespace trembler::insight {

/// An object and a liquid.
using Dip = std::pair<ObjectId, ObjectId>;

/// Sets the objects on which liquids do not act, between two frames, or before the first: from the next frame
/// on neither lift nor resistance of its liquid acts on the object of each pair. Earlier settings remain.
void leaveOutDips(World& world, std::span<Dip const> without);

} // namespace trembler::insight
