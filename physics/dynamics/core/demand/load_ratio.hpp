// The masses that rest on bodies.
#pragma once

#include "physics/dynamics/core/bodies.hpp"
#include "physics/dynamics/core/loads.hpp"
#include "physics/dynamics/properties/contacts.hpp"

namespace trembler {

/// The demand of contacts: of all bodies that touch, the greatest ratio of the mass that rests on a body to
/// its own. The masses that rest on it are the masses that forces press onto it. Four directions of pressing
/// are tried: along the main axis of the forces, against it, and across it to either side; the greatest ratio
/// counts. Mass goes from each body in equal shares to all bodies that it touches farther down in that
/// direction, the ground included. 0 if no body presses on another. `loads` by slot of the bodies.
[[nodiscard]] double loadRatio(DynamicsColumns const& columns, BodyTable const& bodies,
                               std::span<TouchingPair const> touching, std::span<LoadSum const> loads);

} // namespace trembler
