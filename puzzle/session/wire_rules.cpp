#include "puzzle/session/wire_rules.hpp"

#include "runtime/level/model/level.hpp"

namespace trembler {

Verdict wireVerdict(Registry const& registry, Store const& store, ObjectId a, ObjectId b, bool connected) {
    if (a == b) {
        return {false, "A wire needs another object at its other end."};
    }
    if (connected) {
        return {false, "There is a wire between them already."};
    }
    for (Connector const& connector : registry.connectors()) {
        if (connector.kind == playersWire) {
            auto const why = connector.refusal(store, a, b);
            return why ? Verdict{false, *why} : Verdict{};
        }
    }
    return {false, "There is no electricity in this program."};
}

} // namespace trembler
