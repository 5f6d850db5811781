// The lift that a liquid lacked to raise an object to its goal, and the torque that turned the object over.
#pragma once

#include "insight/miss/miss.hpp"
#include "runtime/world/world.hpp"

#include <cstdint>

namespace trembler::insight {

/// By how much something should be higher for it to count.
enum class Rise : std::uint8_t {
    clear, ///< a millimetre
    any,   ///< less too, unless it should be moved nearly level: it only begins to sink
};

/// Adds to the miss of an object that should be higher what the liquid around it lacks: the force by which it
/// would lift the object there less than it, what joints tie it to and all that lies on them weigh; and, if
/// the object and what joints tie it to are welded together and carry something, the torque by which that
/// turns them more than the liquid rights them. Carried is what lies on top, through others as well. Does the
/// same for the misses in `besides`. Adds nothing for other objects, for places outside of liquids, and where
/// nothing is lacking. The objects of an added miss: the liquid, the object, and the objects that it is tied
/// to and carries.
void addLift(Miss& miss, World const& world, Rise rise = Rise::clear);

} // namespace trembler::insight
