// Which masses rest on which bodies.
#pragma once

#include "physics/dynamics/core/bodies.hpp"
#include "physics/dynamics/core/loads.hpp"
#include "physics/dynamics/properties/contacts.hpp"

namespace trembler {

/// The demand of contacts: of all bodies that touch, the greatest ratio of the mass that rests on a body to
/// its own. The masses that rest on it are those that forces press onto it. They may press in any direction:
/// along the one that most forces have, against it, or across it to either side, whichever gives most. Mass
/// goes from each body in equal shares to all that it touches farther down in that direction, the ground
/// included. 0 where nothing presses on anything. `loads` by slot of the bodies.
[[nodiscard]] double loadRatio(DynamicsColumns const& columns, BodyTable const& bodies,
                               std::span<TouchingPair const> touching, std::span<LoadSum const> loads);

} // namespace trembler
