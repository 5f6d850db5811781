// The shape of an object where it is.
#pragma once

#include "physics/dynamics/properties/shapes/overlap.hpp"
#include "runtime/object/object_id.hpp"
#include "runtime/world/store.hpp"

#include <optional>

namespace trembler {

/// Nothing if the object has no shape, a shape without pieces, or no position. An object without a rotation
/// is upright. Refers to the store's shape, and is valid until that changes.
[[nodiscard]] std::optional<PlacedShape> placedShapeOf(Store const& store, ObjectId object);

} // namespace trembler
