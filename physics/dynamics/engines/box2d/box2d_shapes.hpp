// Converts our shapes to Box2D's.
#pragma once

#include "physics/dynamics/core/engine.hpp"

#include <box2d/box2d.h>

#include <functional>

namespace trembler {

/// Calls `take` with the Box2D shapes of a body, in a fixed order, in units of 1/`scale` m relative to its
/// centre of mass: at most three for each piece.
void makeShapes(BodySpec const& spec, double scale, std::function<void(b2Shape const&)> const& take);

} // namespace trembler
