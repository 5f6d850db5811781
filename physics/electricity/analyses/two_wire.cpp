#include "physics/electricity/analyses/two_wire.hpp"

#include <boost/graph/biconnected_components.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace trembler {
namespace {

// Every connection is two directed edges of a compressed graph. For the algorithm this is the same as an
// undirected graph, whose edges are listed at both ends, too; building it is an order of magnitude cheaper.
using Vertex = std::uint32_t;
using BoostGraph = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property,
                                                      boost::no_property, boost::no_property, Vertex, Vertex>;
using Terminals = std::span<Circuit::Terminal const>;

constexpr Vertex sourceNode = 0;
constexpr Vertex returnNode = 1;
constexpr Vertex firstObject = 2;

// The edges of one network's part of a circuit, with source node, return node and the virtual edge between
// them, which comes first.
std::vector<std::pair<Vertex, Vertex>> edgesOf(Circuit const& circuit, Terminals sources, Terminals returns) {
    std::string_view const network = sources.front().network;
    std::vector<std::pair<Vertex, Vertex>> edges;
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
    BoostGraph const graph(boost::edges_are_sorted, edges.begin(), edges.end(), circuit.size() + firstObject);
    constexpr std::size_t noBlock =
        std::numeric_limits<std::size_t>::max(); // of the other direction of an edge
    std::vector<std::size_t> blocks(edges.size(), noBlock);
    boost::biconnected_components(
        graph, boost::make_iterator_property_map(blocks.begin(), boost::get(boost::edge_index, graph)));
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

// The terminals of one network from a list of all.
Terminals ofNetwork(std::vector<Circuit::Terminal> const& all, std::string_view network) {
    auto const before = [](Circuit::Terminal const& t, std::string_view name) { return t.network < name; };
    auto const after = [](std::string_view name, Circuit::Terminal const& t) { return name < t.network; };
    auto const from = std::lower_bound(all.begin(), all.end(), network, before);
    return {from, std::upper_bound(from, all.end(), network, after)};
}

} // namespace

void markTwoWire(Circuit const& circuit, std::vector<std::uint8_t>& on) {
    Terminals rest(circuit.sources);
    while (!rest.empty()) {
        std::string_view const network = rest.front().network;
        Terminals const sources = ofNetwork(circuit.sources, network);
        Terminals const returns = ofNetwork(circuit.returns, network);
        if (!returns.empty()) {
            markNetwork(circuit, sources, returns, on);
        }
        rest = rest.subspan(sources.size());
    }
}

bool TwoWireElectricity::faithful(Store const& store) {
    return isFaithful(ElectricalLevel::twoWire, store);
}

bool TwoWireElectricity::suits(Store const& store) {
    return sufficientLevel(store).level != ElectricalLevel::nodal;
}

} // namespace trembler
