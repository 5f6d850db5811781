// Whether sentences about goals call an object a lamp. This depends on its properties, never on its name.
#pragma once

#include "runtime/world/world.hpp"

namespace trembler {

/// Whether the object consumes electricity and is made of glass, so that its current makes light. The same
/// objects are drawn as bulbs. False for an invalid id.
[[nodiscard]] bool isLamp(World const& world, ObjectId id);
/// The same for objects made from a part.
[[nodiscard]] bool isLamp(Prototype const& part);

} // namespace trembler
