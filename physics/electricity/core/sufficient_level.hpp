// The detail level of electricity that one circuit of a scene needs.
#pragma once

#include "physics/electricity/core/circuit.hpp"
#include "physics/electricity/core/netlist.hpp"
#include "physics/electricity/properties/scene_level.hpp"

#include <optional>

namespace trembler {

/// The first property of an object that needs nodal analysis, if any.
[[nodiscard]] std::optional<ElectricalReason> reasonForNodal(NodalColumns const& columns, ObjectId object);

/// For one circuit: single-cable in a world that never had a return, as otherwise no current could flow; else
/// nodal if any of its objects has a resistance, an EMF, a rating or a fuse; else two-wire.
[[nodiscard]] SufficientLevel sufficientLevel(Circuit const& circuit, NodalColumns const& columns,
                                              Column<ElectricalReturn> const& returns);

} // namespace trembler
