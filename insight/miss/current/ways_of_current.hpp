// How many connections hold a circuit closed.
#pragma once

#include "runtime/world/world.hpp"

namespace trembler::insight {

/// Of how many connections of the electricity graph at least one would have to be opened for each, so that no
/// path leads from the object to any source any more, or none to any return: a minimum cut, found as the
/// maximum flow along paths that share no connection (Ford and Fulkerson 1956). 0 if there is no path even
/// now; at most the number of the object's connections. An object that is a source itself counts its paths to
/// returns, and the other way round. O(ways * connections).
[[nodiscard]] int waysOfCurrent(World const& world, ObjectId object);

} // namespace trembler::insight
