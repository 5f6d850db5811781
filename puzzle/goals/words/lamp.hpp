// Whether sentences about goals call an object a lamp: that follows from its properties, never from its name.
#pragma once

#include "runtime/world/world.hpp"

namespace trembler {

/// Whether the object is a user of electricity made of glass, so that its current makes light. The same
/// objects are drawn as bulbs. False for an invalid id.
[[nodiscard]] bool isLamp(World const& world, ObjectId id);
/// The same for the objects made from a part.
[[nodiscard]] bool isLamp(Prototype const& part);

} // namespace trembler
