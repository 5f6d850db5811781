// Which detail level of electricity one circuit of a scene calls for.
#pragma once

#include "physics/electricity/core/circuit.hpp"
#include "physics/electricity/core/netlist.hpp"
#include "physics/electricity/properties/scene_level.hpp"

#include <optional>

namespace trembler {

/// The property of an object that calls for nodal analysis, if it has any.
[[nodiscard]] std::optional<ElectricalReason> callsForNodal(NodalColumns const& columns, ObjectId object);

/// Of one circuit: single-cable in a world that never had a return, as without one nothing could flow; else
/// nodal if anything in it has a resistance, an EMF, a rating or a fuse; else two-wire.
[[nodiscard]] SufficientLevel sufficientLevel(Circuit const& circuit, NodalColumns const& columns,
                                              Column<ElectricalReturn> const& returns);

} // namespace trembler
