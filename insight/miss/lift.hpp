// What a liquid lacked to lift an object to where it should be, and what turned it over.
#pragma once

#include "insight/miss/miss.hpp"
#include "runtime/world/world.hpp"

namespace trembler::insight {

/// Adds to the miss of an object that should be higher what the liquid around it lacks: the force by which it
/// would lift the object there less than it and all that it carries weigh; and, if the object and what joints
/// tie it to are welded together and carry something, the torque by which that turns them more than the
/// liquid rights them. Carried is what lies on top, through others as well. Does the same for what stood in
/// the way besides. Adds nothing for other objects, for places outside of liquids, and where nothing is
/// lacking. The objects of what is added: the liquid, the object, and what it is tied to and carries.
void addLift(Miss& miss, World const& world);

} // namespace trembler::insight
