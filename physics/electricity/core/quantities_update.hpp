// Writes the results of the more expensive detail levels of electricity.
#pragma once

#include "physics/electricity/core/circuit.hpp"
#include "physics/electricity/core/state_update.hpp"
#include "physics/electricity/core/sufficient_level.hpp"
#include "physics/electricity/properties/quantities.hpp"

#include <functional>
#include <span>
#include <vector>

namespace trembler {

/// The results for one circuit.
struct CircuitQuantities {
    ElectricalQuantities::Circuit circuit;
    std::vector<ElectricalQuantities::Entry> entries; ///< every object of the circuit
};

/// The results that are known before the analysis: the circuit's objects, and the reason for its level.
[[nodiscard]] CircuitQuantities quantitiesOf(Circuit const& circuit, SufficientLevel const& level);

/// An event for the trace: `what` happened to `object` in the circuit of that number.
using ReportOfCircuit = std::function<EventId(std::string_view what, ObjectId object, std::uint32_t circuit)>;

/// Replaces the results of the analysed circuits, and removes circuits that no longer exist. `report` is
/// called for newly shorted sources, for newly floating islands, and for overloaded fuses.
void writeQuantities(ElectricalQuantities& quantities, std::vector<CircuitQuantities>& found,
                     StateUpdate const& update, std::uint64_t frame, ReportOfCircuit const& report);

/// The end of the update() of a detail level with quantities: writes state and quantities if they are new.
template <class Access>
void writeStateAndQuantities(Access& access, StateUpdate const& update,
                             std::vector<CircuitQuantities>& found) {
    auto const record = [&](std::string_view what, std::span<ObjectId const> objects,
                            std::span<EventId const> causes) { return access.event(what, objects, causes); };
    if (update.circuits() > 0 || !update.gone().empty() || update.sawAll()) {
        writeQuantities(access.template derive<ElectricalQuantities>(), found, update, access.frame(),
                        [&](std::string_view what, ObjectId object, std::uint32_t circuit) {
                            return record(what, std::span(&object, 1), update.causes(circuit));
                        });
    }
    if (update.anything()) {
        update.writeTo(access.template derive<ElectricalState>(), access.frame(), record);
    }
}

} // namespace trembler
