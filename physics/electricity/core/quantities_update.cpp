#include "physics/electricity/core/quantities_update.hpp"

#include <algorithm>

namespace trembler {

CircuitQuantities quantitiesOf(Circuit const& circuit, SufficientLevel const& level) {
    CircuitQuantities made;
    made.circuit.first = *std::min_element(circuit.objects.begin(), circuit.objects.end());
    made.circuit.objects = circuit.size();
    made.circuit.level = level.level;
    made.circuit.reason = level.reason;
    made.circuit.because = level.because;
    made.entries.resize(circuit.size());
    for (std::uint32_t v = 0; v < circuit.size(); ++v) {
        made.entries[v].object = circuit.objects[v];
        made.entries[v].circuit = made.circuit.first;
    }
    return made;
}

void writeQuantities(ElectricalQuantities& quantities, std::vector<CircuitQuantities>& found,
                     StateUpdate const& update, std::uint64_t frame, ReportOfCircuit const& report) {
    auto const before = [&](ObjectId first) -> ElectricalQuantities::Circuit const* {
        return quantities.circuitOf(first);
    };
    // Events are recorded before the previous results are overwritten.
    for (std::uint32_t c = 0; c < found.size(); ++c) {
        for (ElectricalQuantities::Entry& entry : found[c].entries) {
            if (entry.overload > 1) {
                entry.event = report("overloaded", entry.object, c);
            }
        }
        auto const& circuit = found[c].circuit;
        for (ObjectId const source : circuit.shorted) {
            auto const* const was = before(source);
            if (was == nullptr || !std::binary_search(was->shorted.begin(), was->shorted.end(), source)) {
                (void)report("short circuit", source, c);
            }
        }
        auto const* const entry = quantities.find(circuit.first);
        if (circuit.floating && circuit.objects > 1 && (entry == nullptr || !entry->floating)) {
            (void)report("floating", circuit.first, c);
        }
    }
    if (update.sawAll()) {
        quantities.byIndex.clear();
        quantities.circuits.clear();
    }
    for (ObjectId const id : update.gone()) {
        if (quantities.find(id) != nullptr) {
            quantities.byIndex[id.index] = {};
        }
    }
    for (CircuitQuantities const& one : found) {
        for (ElectricalQuantities::Entry const& entry : one.entries) {
            if (quantities.byIndex.size() <= entry.object.index) {
                quantities.byIndex.resize(entry.object.index + std::size_t{1});
            }
            quantities.byIndex[entry.object.index] = entry;
        }
    }
    // A circuit is unchanged unless it was analysed, or its first object is now in another one.
    std::vector<ObjectId> looked;
    looked.reserve(found.size());
    for (CircuitQuantities const& one : found) {
        looked.push_back(one.circuit.first);
    }
    std::sort(looked.begin(), looked.end());
    std::erase_if(quantities.circuits, [&](ElectricalQuantities::Circuit const& circuit) {
        auto const* const entry = quantities.find(circuit.first);
        return entry == nullptr || entry->circuit != circuit.first ||
               std::binary_search(looked.begin(), looked.end(), circuit.first);
    });
    for (CircuitQuantities& one : found) {
        quantities.circuits.push_back(std::move(one.circuit));
    }
    std::sort(quantities.circuits.begin(), quantities.circuits.end(),
              [](auto const& a, auto const& b) { return a.first < b.first; });
    quantities.frame = frame;
}

} // namespace trembler
