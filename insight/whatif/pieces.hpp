// The objects that belong together, because they were made from one part.
#pragma once

#include "runtime/world/store.hpp"

#include <vector>

namespace trembler::insight {

/// All living objects of the part that the object was made from, or the object alone; ascending. Empty if it
/// does not exist.
[[nodiscard]] std::vector<ObjectId> piecesWith(Store const& store, ObjectId object);

} // namespace trembler::insight
