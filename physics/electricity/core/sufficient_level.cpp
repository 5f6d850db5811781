#include "physics/electricity/core/sufficient_level.hpp"

#include "runtime/world/store.hpp"

#include <fmt/format.h>

namespace trembler {
namespace {

template <class P>
ObjectId firstOwner(Store const& store) {
    auto const* const column = store.findColumn<P>();
    return column == nullptr || column->empty() ? ObjectId{} : column->owners().front();
}

constexpr std::uint64_t never = 1; // the structure version of a column that never had a row

template <class P>
bool neverHadAny(Store const& store) {
    auto const* const column = store.findColumn<P>();
    return column == nullptr || column->structureVersion() == never;
}

} // namespace

bool neverHadReturns(Column<ElectricalReturn> const& returns) {
    return returns.structureVersion() == never;
}

std::optional<ElectricalReason> callsForNodal(NodalColumns const& columns, ObjectId object) {
    if (columns.resistances.has(object)) {
        return ElectricalReason::resistance;
    }
    if (columns.emfs.has(object)) {
        return ElectricalReason::emf;
    }
    if (columns.ratings.has(object)) {
        return ElectricalReason::rating;
    }
    if (columns.fuses.has(object)) {
        return ElectricalReason::fuse;
    }
    return std::nullopt;
}

SufficientLevel sufficientLevel(Circuit const& circuit, NodalColumns const& columns,
                                Column<ElectricalReturn> const& returns) {
    if (neverHadReturns(returns)) {
        return {ElectricalLevel::singleCable, ElectricalReason::noReturn, {}};
    }
    SufficientLevel found;
    for (ObjectId const object : circuit.objects) {
        if (!found.because.valid() || object < found.because) {
            if (auto const reason = callsForNodal(columns, object)) {
                found = {ElectricalLevel::nodal, *reason, object};
            }
        }
    }
    return found;
}

SufficientLevel sufficientLevel(Store const& store) {
    auto const* const returns = store.findColumn<ElectricalReturn>();
    if (returns == nullptr || neverHadReturns(*returns)) {
        return {ElectricalLevel::singleCable, ElectricalReason::noReturn, {}};
    }
    if (ObjectId const id = firstOwner<Resistance>(store); id.valid()) {
        return {ElectricalLevel::nodal, ElectricalReason::resistance, id};
    }
    if (ObjectId const id = firstOwner<Emf>(store); id.valid()) {
        return {ElectricalLevel::nodal, ElectricalReason::emf, id};
    }
    if (ObjectId const id = firstOwner<RatedPower>(store); id.valid()) {
        return {ElectricalLevel::nodal, ElectricalReason::rating, id};
    }
    if (ObjectId const id = firstOwner<Fuse>(store); id.valid()) {
        return {ElectricalLevel::nodal, ElectricalReason::fuse, id};
    }
    return {};
}

bool isFaithful(ElectricalLevel level, Store const& store) {
    auto const* const returns = store.findColumn<ElectricalReturn>();
    bool const wholeCables = returns == nullptr || neverHadReturns(*returns);
    bool const onOffOnly = neverHadAny<Resistance>(store) && neverHadAny<Emf>(store) &&
                           neverHadAny<RatedPower>(store) && neverHadAny<Fuse>(store);
    switch (level) {
    case ElectricalLevel::singleCable:
        return wholeCables;
    case ElectricalLevel::twoWire:
        return !wholeCables && onOffOnly;
    case ElectricalLevel::flow:
        return false;
    case ElectricalLevel::nodal:
        return true;
    }
    return false;
}

std::string whyElectricalLevel(Store const& store) {
    SufficientLevel const found = sufficientLevel(store);
    if (found.because.valid()) {
        return fmt::format("{}, because '{}' has {}; circuits without such a thing are still on or off only",
                           nameOf(found.level), store.nameOf(found.because), nameOf(found.reason));
    }
    return fmt::format("{}: {}", nameOf(found.level), nameOf(found.reason));
}

} // namespace trembler
