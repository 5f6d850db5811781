// The connections that hold a circuit closed.
#pragma once

#include "insight/miss/miss.hpp"
#include "runtime/world/world.hpp"

#include <vector>

namespace trembler::insight {

/// As few connections of the electricity graph as possible which, if all are opened, leave no path from the
/// object to any source, or none to any return: a minimum cut, found as the maximum flow along paths that
/// share no connection (Ford and Fulkerson 1956); of several the one nearest to the object, each way
/// beginning on the object's side, without names. Empty if there is no path even now; at most the object's
/// connections. An object that is a source itself has its paths to returns cut, and the other way round.
/// O(ways * connections).
[[nodiscard]] std::vector<CurrentWay> waysOfCurrent(World const& world, ObjectId object);

} // namespace trembler::insight
