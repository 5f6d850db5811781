// The detail level of electricity that a scene needs: the cheapest that takes all its properties into
// account. For a single circuit: core/sufficient_level.hpp.
#pragma once

#include "physics/electricity/properties/electrical.hpp"
#include "physics/electricity/properties/quantities.hpp"
#include "runtime/property/column.hpp"

#include <string>

namespace trembler {

class Store;

/// A level, and the first object, by id, that needs it.
struct SufficientLevel {
    ElectricalLevel level = ElectricalLevel::twoWire;
    ElectricalReason reason = ElectricalReason::onOffOnly;
    ObjectId because;
};

/// Whether the world has never had a return: then a connection is a whole cable, return included. In a world
/// that lost its last return this must not apply, or lamps would light up.
[[nodiscard]] bool neverHadReturns(Column<ElectricalReturn> const& returns);

/// For the whole scene: the most expensive level that any of its circuits may need.
[[nodiscard]] SufficientLevel sufficientLevel(Store const& store);

/// Whether a level takes all electrical properties into account that the scene has ever had, so that other
/// such levels switch on the same objects: single-cable in a world that never had a return; two-wire in one
/// that had returns but no object that needs nodal analysis; nodal always; flow never.
[[nodiscard]] bool isFaithful(ElectricalLevel level, Store const& store);

/// Why the scene needs that level, in words for people: "nodal, because 'lamp' has a rated power".
[[nodiscard]] std::string whyElectricalLevel(Store const& store);

} // namespace trembler
