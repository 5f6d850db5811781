#include "physics/electricity/quantities.hpp"

#include <algorithm>

namespace trembler {

ElectricalQuantities::Circuit const* ElectricalQuantities::circuitOf(ObjectId id) const {
    Entry const* const entry = find(id);
    if (entry == nullptr) {
        return nullptr;
    }
    auto const at = std::lower_bound(circuits.begin(), circuits.end(), entry->circuit,
                                     [](Circuit const& c, ObjectId first) { return c.first < first; });
    return at == circuits.end() || at->first != entry->circuit ? nullptr : &*at;
}

std::string_view nameOf(ElectricalLevel level) {
    switch (level) {
    case ElectricalLevel::singleCable:
        return "single-cable";
    case ElectricalLevel::twoWire:
        return "two-wire";
    case ElectricalLevel::flow:
        return "flow";
    case ElectricalLevel::nodal:
        break;
    }
    return "nodal";
}

std::string_view nameOf(ElectricalReason reason) {
    switch (reason) {
    case ElectricalReason::noReturn:
        return "there never was a return: cables are whole";
    case ElectricalReason::onOffOnly:
        return "nothing has a resistance, an EMF, a rating or a fuse";
    case ElectricalReason::resistance:
        return "a resistance";
    case ElectricalReason::emf:
        return "an EMF";
    case ElectricalReason::rating:
        return "a rated power";
    case ElectricalReason::fuse:
        return "a fuse";
    case ElectricalReason::asked:
        break;
    }
    return "asked for";
}

} // namespace trembler
