#include "physics/electricity/core/circuit.hpp"

#include <algorithm>

namespace trembler {

std::vector<std::string_view> Circuit::terminalNetworks() const {
    std::vector<std::string_view> found;
    for (auto const* const terminals : {&sources, &returns}) {
        for (Terminal const& terminal : *terminals) {
            found.push_back(terminal.network);
        }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

void CircuitWalk::begin(ElectricityColumns const& columns) {
    base_ = next_;
    std::span<ObjectId const> const vertices = columns.graph.owners();
    std::size_t const bound = vertices.empty() ? 0 : vertices.back().index + std::size_t{1};
    if (places_.size() < bound) {
        places_.resize(bound);
    }
}

std::uint32_t CircuitWalk::enter(ElectricityColumns const& columns, ObjectId id, Circuit& circuit) {
    std::uint32_t const vertex = circuit.size();
    places_[id.index] = {next_, vertex};
    circuit.objects.push_back(id);
    Conductor const* const conductor = columns.conductors.find(id);
    std::string_view const only = conductor == nullptr ? std::string_view{} : conductor->network;
    circuit.networks.push_back(only);
    // A device of one network is no terminal of another.
    if (ElectricalSource const* const source = columns.sources.find(id)) {
        if (only.empty() || only == source->network) {
            circuit.sources.push_back({source->network, vertex});
        }
    }
    if (ElectricalReturn const* const returning = columns.returns.find(id)) {
        if (only.empty() || only == returning->network) {
            circuit.returns.push_back({returning->network, vertex});
        }
    }
    return vertex;
}

bool CircuitWalk::walk(ElectricityColumns const& columns, ObjectId seed, Circuit& circuit) {
    if (!columns.graph.has(seed) || circuitOf(seed) != none) {
        return false;
    }
    circuit.objects.clear();
    circuit.offsets.assign(1, 0);
    circuit.neighbours.clear();
    circuit.networks.clear();
    circuit.sources.clear();
    circuit.returns.clear();
    enter(columns, seed, circuit);
    for (std::size_t open = 0; open < circuit.objects.size(); ++open) {
        for (ElectricityGraph::Connection const& connection :
             columns.graph[circuit.objects[open]].connections) {
            if (!columns.graph.has(connection.to)) {
                continue; // destroyed, and the resolver has not run since
            }
            Place const& place = places_[connection.to.index];
            circuit.neighbours.push_back(place.circuit == next_ ? place.vertex
                                                                : enter(columns, connection.to, circuit));
        }
        circuit.offsets.push_back(static_cast<std::uint32_t>(circuit.neighbours.size()));
    }
    std::sort(circuit.sources.begin(), circuit.sources.end());
    std::sort(circuit.returns.begin(), circuit.returns.end());
    ++next_;
    return true;
}

} // namespace trembler
