// Sources whose two sides are joined without a load.
#pragma once

#include "runtime/object/object_id.hpp"
#include "runtime/world/world.hpp"

#include <vector>

namespace trembler::insight {

/// The sources, ascending, from which a current flows to a return of their network only through conductors
/// that have no resistance and do nothing with it: no lamp, coil, motor or other device. Of such a circuit
/// nothing else works. A pure function of the electricity graph and the derived currents, so it is known
/// for recorded moments, too. Empty unless currents are computed (docs/electricity.md: nodal): without
/// them a short circuit changes nothing.
[[nodiscard]] std::vector<ObjectId> shortCircuits(World const& world);

/// The first of them in the circuit of this object; invalid if there is none.
[[nodiscard]] ObjectId shortCircuitBeside(World const& world, ObjectId object);

} // namespace trembler::insight
