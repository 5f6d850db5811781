#include "physics/electricity/properties/scene_level.hpp"

#include "physics/electricity/properties/ratings.hpp"
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
        return fmt::format("{}, because '{}' has {}; circuits without one are still only on or off",
                           nameOf(found.level), store.nameOf(found.because), nameOf(found.reason));
    }
    return fmt::format("{}: {}", nameOf(found.level), nameOf(found.reason));
}

} // namespace trembler
