// What Dynamics adds to new objects.
#pragma once

#include "runtime/object/object_id.hpp"

namespace trembler {

class Store;

/// An object with a shape gets a rotation and, unless it is fixed, a velocity, an angular velocity and a
/// mass: its density (1000 kg/m³ where none is stated) times its area times the depth of the world.
void completeBody(Store& store, ObjectId id);

} // namespace trembler
