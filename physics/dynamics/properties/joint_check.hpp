// Whether a joint can hold the objects of a store: for files, and for tools that are about to make one.
#pragma once

#include "physics/dynamics/properties/joint.hpp"
#include "runtime/world/store.hpp"

#include <optional>
#include <string>

namespace trembler {

/// The fault of a joint between objects of the store, before or after their completion, and the expected
/// condition, in words; nothing if it is valid. The joint need not be in the store. Any thread that may read
/// the store.
[[nodiscard]] std::optional<std::string> refuseJoint(Store const& store, Joint const& joint);

/// Whether an object is one that a joint can hold: it has a place and a valid shape, and is no liquid.
[[nodiscard]] bool canBeJoined(Store const& store, ObjectId object);

} // namespace trembler
