// Lets electromagnets and motors do nothing, or keeps a magnet on, while currents flow as before.
#pragma once

#include "runtime/world/world.hpp"

#include <span>

namespace trembler::insight {

/// Between two frames, or before the first: from the next frame on the object neither attracts anything as a
/// magnet nor turns as a motor. For other objects nothing changes.
void stillDevices(World& world, std::span<ObjectId const> devices);

/// From the next frame on an electromagnet stays as it is, whatever its current does. For other objects
/// nothing changes.
void holdMagnets(World& world, std::span<ObjectId const> magnets);

} // namespace trembler::insight
