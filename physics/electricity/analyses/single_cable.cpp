#include "physics/electricity/analyses/single_cable.hpp"

#include <algorithm>

namespace trembler {

void markSingleCable(Circuit const& circuit, std::vector<std::uint8_t>& on) {
    std::vector<std::uint32_t> reached;
    std::vector<std::uint8_t> met;
    for (auto source = circuit.sources.begin(); source != circuit.sources.end();) {
        std::string_view const network = source->network;
        met.assign(circuit.size(), 0);
        reached.clear();
        for (; source != circuit.sources.end() && source->network == network; ++source) {
            met[source->vertex] = 1;
            reached.push_back(source->vertex);
        }
        for (std::size_t open = 0; open < reached.size(); ++open) {
            on[reached[open]] = 1;
            for (std::uint32_t const v : circuit.neighboursOf(reached[open])) {
                if (met[v] == 0 && circuit.takesPart(v, network)) {
                    met[v] = 1;
                    reached.push_back(v);
                }
            }
        }
    }
}

bool SingleCableElectricity::faithful(Store const& store) {
    return isFaithful(ElectricalLevel::singleCable, store);
}

bool SingleCableElectricity::suits(Store const& store) {
    return sufficientLevel(store).level == ElectricalLevel::singleCable;
}

} // namespace trembler
