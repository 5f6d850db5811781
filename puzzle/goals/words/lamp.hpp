// What a lamp is to words about goals: it follows from what an object is, never from its name.
#pragma once

#include "runtime/world/world.hpp"

namespace trembler {

/// Whether the object is a user of electricity made of glass: light is then what its current is for. It is
/// what is drawn as a bulb, too. False for an invalid id.
[[nodiscard]] bool isLamp(World const& world, ObjectId id);
/// The same of what is made from a part.
[[nodiscard]] bool isLamp(Prototype const& part);

} // namespace trembler
