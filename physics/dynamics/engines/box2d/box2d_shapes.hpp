// Our shapes in Box2D's terms.
#pragma once

#include "physics/dynamics/core/engine.hpp"

#include <box2d/box2d.h>

#include <functional>

namespace trembler {

/// Gives `take` the Box2D shapes that make up a body, in a fixed order, in units of 1/`scale` m around its
/// centre of mass: at most three for each piece.
void makeShapes(BodySpec const& spec, double scale, std::function<void(b2Shape const&)> const& take);

} // namespace trembler
