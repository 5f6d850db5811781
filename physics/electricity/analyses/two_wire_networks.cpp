#include "physics/electricity/analyses/two_wire_networks.hpp"

#include "physics/electricity/analyses/blocks.hpp"
#include "physics/electricity/analyses/plain_forest.hpp"
#include "physics/electricity/core/network_members.hpp"

#include <algorithm>

namespace trembler {
namespace {

constexpr std::uint32_t twoWireSource = 0; // of a network's graph
constexpr std::uint32_t twoWireReturn = 1;

/// The graphs of networks, one after another: source node, return node, the network's own vertices, and the
/// nodes of the forest where these are joined to plain conductors, with the paths between these nodes.
class TwoWireGraph {
public:
    TwoWireGraph(Circuit const& circuit, NetworkMembers const& members, PlainForest& forest,
                 std::vector<std::uint8_t>& on)
        : circuit_(circuit), members_(members), forest_(forest), on_(on),
          numbers_(circuit.size(), PlainForest::none) {}

    void mark(std::string_view network) {
        joinTerminals(network);
        joinOwn(network);
        joinForest();
        markLive();
        for (std::uint32_t const v : vertices_) {
            numbers_[v] = PlainForest::none;
        }
        vertices_.clear();
        touched_.clear();
        edges_.clear();
    }

private:
    /// A connection, or a path in the forest: down from `above` to `below`, or through the block `above`.
    struct Edge {
        std::uint32_t a = 0;
        std::uint32_t b = 0;
        std::uint32_t above = PlainForest::none;
        std::uint32_t below = PlainForest::none;
    };

    // The number of a vertex in the graph of this network.
    std::uint32_t numberOf(std::uint32_t v) {
        if (numbers_[v] == PlainForest::none) {
            numbers_[v] = static_cast<std::uint32_t>(vertices_.size()) + 2;
            vertices_.push_back(v);
            if (members_.isPlain(v)) {
                touched_.push_back(v);
            }
        }
        return numbers_[v];
    }
    void join(std::uint32_t v, std::uint32_t w) { edges_.push_back({numberOf(v), numberOf(w)}); }

    void joinTerminals(std::string_view network) {
        edges_.push_back({twoWireSource, twoWireReturn}); // comes first: its block is the live one
        for (Circuit::Terminal const& source : terminalsOf(circuit_.sources, network)) {
            edges_.push_back({twoWireSource, numberOf(source.vertex)});
        }
        for (Circuit::Terminal const& returning : terminalsOf(circuit_.returns, network)) {
            edges_.push_back({twoWireReturn, numberOf(returning.vertex)});
        }
    }
    void joinOwn(std::string_view network) {
        for (std::uint32_t const v : members_.own(network)) {
            for (std::uint32_t const w : members_.plainNeighboursOf(v)) {
                join(v, w);
            }
            for (std::uint32_t const w : members_.ownNeighboursOf(v, network)) {
                if (v < w) {
                    join(v, w);
                }
            }
        }
    }
    // Joins the nodes of the forest that are touched or at which paths between touched conductors meet: an
    // edge for the path between any two neighbours among these nodes.
    void joinForest() {
        auto const before = [&](std::uint32_t a, std::uint32_t b) {
            return forest_.placeOf(a) < forest_.placeOf(b);
        };
        std::vector<std::uint32_t> nodes = touched_;
        std::sort(nodes.begin(), nodes.end(), before);
        for (std::size_t i = nodes.size(); i > 1; --i) {
            if (forest_.sameTree(nodes[i - 2], nodes[i - 1])) {
                nodes.push_back(forest_.commonAncestor(nodes[i - 2], nodes[i - 1]));
            }
        }
        std::sort(nodes.begin(), nodes.end(), before);
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
        // The conductors of a block that are nodes here, or through which a path enters the block.
        std::vector<std::pair<std::uint32_t, std::uint32_t>> inBlocks; // block, vertex
        for (std::size_t i = 1; i < nodes.size(); ++i) {
            if (forest_.sameTree(nodes[i - 1], nodes[i])) {
                joinPath(forest_.commonAncestor(nodes[i - 1], nodes[i]), nodes[i], inBlocks);
            }
        }
        std::sort(inBlocks.begin(), inBlocks.end());
        for (auto at = inBlocks.begin(); at != inBlocks.end();) {
            auto const end =
                std::find_if(at, inBlocks.end(), [&](auto const& other) { return other.first != at->first; });
            joinBlock({at, end});
            at = end;
        }
    }
    void joinPath(std::uint32_t above, std::uint32_t below,
                  std::vector<std::pair<std::uint32_t, std::uint32_t>>& inBlocks) {
        std::uint32_t top = above;
        if (forest_.isBlock(above)) {
            top = forest_.childTowards(above, below);
            inBlocks.emplace_back(above, top);
        }
        std::uint32_t bottom = below;
        if (forest_.isBlock(below)) {
            bottom = forest_.parentOf(below);
            inBlocks.emplace_back(below, bottom);
        }
        if (top != bottom) {
            edges_.push_back({numberOf(top), numberOf(bottom), top, bottom});
        }
    }
    // Joins the conductors in a cycle, so that any two of them have two paths between them, as in the block
    // itself.
    void joinBlock(std::span<std::pair<std::uint32_t, std::uint32_t> const> in) {
        std::size_t const count = in.size() == 2 ? 1 : in.size();
        for (std::size_t i = 0; i < count; ++i) {
            edges_.push_back({numberOf(in[i].second), numberOf(in[(i + 1) % in.size()].second), in[i].first,
                              PlainForest::none});
        }
    }
    void markLive() {
        struct Directed {
            std::uint32_t from;
            std::uint32_t to;
            std::uint32_t edge;
        };
        std::vector<Directed> directed;
        directed.reserve(2 * edges_.size());
        for (std::uint32_t e = 0; e < edges_.size(); ++e) {
            directed.push_back({edges_[e].a, edges_[e].b, e});
            directed.push_back({edges_[e].b, edges_[e].a, e});
        }
        std::stable_sort(directed.begin(), directed.end(),
                         [](Directed const& x, Directed const& y) { return x.from < y.from; });
        std::vector<BlockEdge> ends;
        ends.reserve(directed.size());
        for (Directed const& one : directed) {
            ends.emplace_back(one.from, one.to);
        }
        std::vector<std::size_t> const blocks = blocksOf(ends, vertices_.size() + 2);
        for (std::size_t d = 0; d < directed.size(); ++d) {
            if (blocks[d] == blocks.front()) {
                mark(edges_[directed[d].edge]);
            }
        }
    }
    void mark(Edge const& edge) {
        for (std::uint32_t const end : {edge.a, edge.b}) {
            if (end >= 2) {
                on_[vertices_[end - 2]] = 1;
            }
        }
        if (edge.below != PlainForest::none) {
            forest_.markPath(edge.above, edge.below);
        } else if (edge.above != PlainForest::none) {
            forest_.markBlock(edge.above);
        }
    }

    Circuit const& circuit_;
    NetworkMembers const& members_;
    PlainForest& forest_;
    std::vector<std::uint8_t>& on_;
    std::vector<std::uint32_t> numbers_;  // by vertex: in the graph of this network, or none
    std::vector<std::uint32_t> vertices_; // by number, less 2
    std::vector<std::uint32_t> touched_;  // plain conductors among these vertices
    std::vector<Edge> edges_;
};

} // namespace

void markTwoWireNetworks(Circuit const& circuit, std::span<std::string_view const> networks,
                         std::vector<std::uint8_t>& on) {
    NetworkMembers const members(circuit);
    PlainForest forest(circuit, members);
    TwoWireGraph graph(circuit, members, forest, on);
    for (std::string_view const network : networks) {
        graph.mark(network);
    }
    forest.apply(on);
}

} // namespace trembler
