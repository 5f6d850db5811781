// Which detail level of electricity a scene calls for: the cheapest that finds everything that the scene's
// properties ask for. Of a single circuit: core/sufficient_level.hpp.
#pragma once

#include "physics/electricity/properties/electrical.hpp"
#include "physics/electricity/properties/quantities.hpp"
#include "runtime/property/column.hpp"

#include <string>

namespace trembler {

class Store;

/// A level, and the first object, by id, that calls for it.
struct SufficientLevel {
    ElectricalLevel level = ElectricalLevel::twoWire;
    ElectricalReason reason = ElectricalReason::onOffOnly;
    ObjectId because;
};

/// In a world that has never had a return, a connection stands for a whole cable, return included. One that
/// lost its last return must not light up because of that.
[[nodiscard]] bool neverHadReturns(Column<ElectricalReturn> const& returns);

/// Of the whole scene: the most expensive that any of its circuits may call for.
[[nodiscard]] SufficientLevel sufficientLevel(Store const& store);

/// Whether a level takes everything into account that the scene has ever stated about its circuits, so that
/// another such level would turn the same things on: single-cable in a world that never had a return;
/// two-wire in one that had returns but nothing that calls for nodal analysis; nodal always; flow never.
[[nodiscard]] bool isFaithful(ElectricalLevel level, Store const& store);

/// Why the scene calls for that level, as a sentence for people: "nodal, because 'lamp' has a rated power".
[[nodiscard]] std::string whyElectricalLevel(Store const& store);

} // namespace trembler
