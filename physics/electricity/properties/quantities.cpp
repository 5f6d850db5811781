#include "physics/electricity/properties/quantities.hpp"

namespace trembler {

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
