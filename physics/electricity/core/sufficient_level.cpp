#include "physics/electricity/core/sufficient_level.hpp"

namespace trembler {

std::optional<ElectricalReason> reasonForNodal(NodalColumns const& columns, ObjectId object) {
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
            if (auto const reason = reasonForNodal(columns, object)) {
                found = {ElectricalLevel::nodal, *reason, object};
            }
        }
    }
    return found;
}

} // namespace trembler
