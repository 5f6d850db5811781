#include "physics/electricity/analyses/two_wire.hpp"

#include "physics/electricity/analyses/blocks.hpp"
#include "physics/electricity/analyses/two_wire_networks.hpp"
#include "physics/electricity/core/network_members.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace trembler {
namespace {

using Vertex = std::uint32_t;
using Terminals = std::span<Circuit::Terminal const>;

constexpr Vertex sourceNode = 0;
constexpr Vertex returnNode = 1;
constexpr Vertex firstObject = 2;

// The edges of one network's part of a circuit, with source node, return node and the virtual edge between
// them, which comes first.
std::vector<BlockEdge> edgesOf(Circuit const& circuit, Terminals sources, Terminals returns) {
    std::string_view const network = sources.front().network;
    std::vector<BlockEdge> edges;
    edges.reserve(circuit.neighbours.size() + 2 * (1 + sources.size() + returns.size()));
    edges.emplace_back(sourceNode, returnNode);
    for (Circuit::Terminal const& source : sources) {
        edges.emplace_back(sourceNode, source.vertex + firstObject);
    }
    edges.emplace_back(returnNode, sourceNode);
    for (Circuit::Terminal const& returning : returns) {
        edges.emplace_back(returnNode, returning.vertex + firstObject);
    }
    auto source = sources.begin();
    auto returning = returns.begin();
    for (Vertex v = 0; v < circuit.size(); ++v) {
        if (source != sources.end() && source->vertex == v) {
            edges.emplace_back(v + firstObject, sourceNode);
            ++source;
        }
        if (returning != returns.end() && returning->vertex == v) {
            edges.emplace_back(v + firstObject, returnNode);
            ++returning;
        }
        if (!circuit.takesPart(v, network)) {
            continue;
        }
        for (Vertex const w : circuit.neighboursOf(v)) {
            if (circuit.takesPart(w, network)) {
                edges.emplace_back(v + firstObject, w + firstObject);
            }
        }
    }
    return edges;
}

void markNetwork(Circuit const& circuit, Terminals sources, Terminals returns,
                 std::vector<std::uint8_t>& on) {
    auto const edges = edgesOf(circuit, sources, returns);
    std::vector<std::size_t> const blocks = blocksOf(edges, circuit.size() + firstObject);
    std::size_t const live =
        blocks.front(); // the search starts at vertex 0 with its first edge, the virtual one
    for (std::size_t e = 0; e < edges.size(); ++e) {
        if (blocks[e] == live) {
            for (Vertex const end : {edges[e].first, edges[e].second}) {
                if (end >= firstObject) {
                    on[end - firstObject] = 1;
                }
            }
        }
    }
}

} // namespace

void markTwoWire(Circuit const& circuit, std::vector<std::uint8_t>& on) {
    std::vector<std::string_view> networks;
    Terminals rest(circuit.sources);
    while (!rest.empty()) {
        std::string_view const network = rest.front().network;
        if (!terminalsOf(circuit.returns, network).empty()) {
            networks.push_back(network);
        }
        rest = rest.subspan(terminalsOf(circuit.sources, network).size());
    }
    if (networks.size() == 1) { // the usual case; the whole circuit costs less than its forest
        markNetwork(circuit, terminalsOf(circuit.sources, networks.front()),
                    terminalsOf(circuit.returns, networks.front()), on);
    } else if (!networks.empty()) {
        markTwoWireNetworks(circuit, networks, on);
    }
}

bool TwoWireElectricity::faithful(Store const& store) {
    return isFaithful(ElectricalLevel::twoWire, store);
}

bool TwoWireElectricity::suits(Store const& store) {
    return sufficientLevel(store).level != ElectricalLevel::nodal;
}

} // namespace trembler
