#include "physics/electricity/analyses/max_flow.hpp"

// g++ 12 warns that Boost's iterator over all edges may begin with an uninitialised edge.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>

namespace trembler {
namespace {

using Traits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;
using Edge = Traits::edge_descriptor;
struct Arc {
    Microamperes capacity = 0;
    Microamperes residual = 0;
    Edge reverse;
};
struct Node {
    Edge predecessor;
    boost::default_color_type colour = boost::white_color;
    long distance = 0;
};
using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, Node, Arc>;
using FlowVertex = Traits::vertex_descriptor;

constexpr std::uint32_t notThere = std::numeric_limits<std::uint32_t>::max();

/// The network of objects in order of their ids. Each object is two nodes, one for the flow in and one for
/// the flow out, joined by an edge with its capacity.
class Network {
public:
    Network(Circuit const& circuit, NetworkMembers const& members, std::string_view network,
            std::span<Microamperes const> capacities)
        : circuit_(circuit) {
        for (auto const vertices : {members.plain(), members.own(network)}) {
            std::copy_if(vertices.begin(), vertices.end(), std::back_inserter(order_),
                         [&](std::uint32_t v) { return capacities[v] > 0; });
        }
        std::sort(order_.begin(), order_.end(),
                  [&](std::uint32_t a, std::uint32_t b) { return circuit.objects[a] < circuit.objects[b]; });
        graph_ = Graph(2 * order_.size() + 3);
        join(gate(), source(), unlimited); // limits the total, however many paths there are
        for (std::uint32_t n = 0; n < order_.size(); ++n) {
            join(in(n), out(n), capacities[order_[n]]);
        }
        for (std::uint32_t n = 0; n < order_.size(); ++n) {
            std::vector<std::uint32_t> neighbours;
            for (auto const joined :
                 {members.plainNeighboursOf(order_[n]), members.ownNeighboursOf(order_[n], network)}) {
                for (std::uint32_t const w : joined) {
                    if (std::uint32_t const m = placeOf(w); m != notThere) {
                        neighbours.push_back(m);
                    }
                }
            }
            std::sort(neighbours.begin(), neighbours.end());
            for (std::uint32_t const m : neighbours) {
                join(out(n), in(m), unlimited);
            }
        }
        joinTerminals(circuit.sources, network, [&](std::uint32_t n) { join(source(), in(n), unlimited); });
        joinTerminals(circuit.returns, network, [&](std::uint32_t n) { join(out(n), sink(), unlimited); });
    }

    [[nodiscard]] MaxFlow solve() {
        MaxFlow found;
        found.total = boost::boykov_kolmogorov_max_flow(
            graph_, boost::get(&Arc::capacity, graph_), boost::get(&Arc::residual, graph_),
            boost::get(&Arc::reverse, graph_), boost::get(&Node::predecessor, graph_),
            boost::get(&Node::colour, graph_), boost::get(&Node::distance, graph_),
            boost::get(boost::vertex_index, graph_), gate(), sink());
        if (found.total >= unlimited) {
            found.total = unlimited;
            return found;
        }
        cut(found);
        for (std::uint32_t const v : order_) {
            found.through.push_back({v, 0});
        }
        peel(found);
        return found;
    }

private:
    [[nodiscard]] static FlowVertex in(std::uint32_t n) { return FlowVertex{2} * n; }
    [[nodiscard]] static FlowVertex out(std::uint32_t n) { return FlowVertex{2} * n + 1; }
    [[nodiscard]] FlowVertex source() const { return 2 * order_.size(); }
    [[nodiscard]] FlowVertex sink() const { return 2 * order_.size() + 1; }
    [[nodiscard]] FlowVertex gate() const { return 2 * order_.size() + 2; }

    /// A vertex's place in the order, or notThere. O(log n).
    [[nodiscard]] std::uint32_t placeOf(std::uint32_t vertex) const {
        ObjectId const object = circuit_.objects[vertex];
        auto const at =
            std::lower_bound(order_.begin(), order_.end(), object,
                             [&](std::uint32_t v, ObjectId const& id) { return circuit_.objects[v] < id; });
        return at == order_.end() || *at != vertex ? notThere
                                                   : static_cast<std::uint32_t>(at - order_.begin());
    }
    void join(FlowVertex from, FlowVertex to, Microamperes capacity) {
        Edge const there = boost::add_edge(from, to, graph_).first;
        Edge const back = boost::add_edge(to, from, graph_).first;
        graph_[there].capacity = capacity;
        graph_[there].reverse = back;
        graph_[back].reverse = there;
    }
    template <class F>
    void joinTerminals(std::vector<Circuit::Terminal> const& all, std::string_view network, F&& f) {
        std::vector<std::uint32_t> places;
        for (Circuit::Terminal const& terminal : terminalsOf(all, network)) {
            if (std::uint32_t const n = placeOf(terminal.vertex); n != notThere) {
                places.push_back(n);
            }
        }
        std::sort(places.begin(), places.end());
        std::for_each(places.begin(), places.end(), f);
    }
    // The nodes that can still be reached from the source are the smallest source side of all minimum cuts
    // (Ford and Fulkerson 1962), whichever maximum flow was found.
    void cut(MaxFlow& found) const {
        std::vector<std::uint8_t> reached(boost::num_vertices(graph_), 0);
        std::vector<FlowVertex> open{gate()};
        reached[gate()] = 1;
        while (!open.empty()) {
            FlowVertex const here = open.back();
            open.pop_back();
            for (auto [at, end] = boost::out_edges(here, graph_); at != end; ++at) {
                FlowVertex const next = boost::target(*at, graph_);
                if (graph_[*at].residual > 0 && reached[next] == 0) {
                    reached[next] = 1;
                    open.push_back(next);
                }
            }
        }
        for (std::uint32_t n = 0; n < order_.size(); ++n) {
            if (reached[in(n)] != 0 && reached[out(n)] == 0) {
                found.bottleneck.push_back(order_[n]);
            }
        }
    }
    // Divides the flow into paths from source to return. Flow in cycles is left and does not count.
    void peel(MaxFlow& found) {
        std::vector<std::size_t> next(boost::num_vertices(graph_), 0);
        std::vector<Edge> way;
        std::vector<std::uint8_t> onPath(boost::num_vertices(graph_), 0);
        FlowVertex here = gate();
        onPath[here] = 1;
        while (true) {
            if (here == sink()) {
                Microamperes least = unlimited;
                for (Edge const e : way) {
                    least = std::min(least, flowOf(e));
                }
                for (Edge const e : way) {
                    graph_[e].residual += least;
                    onPath[boost::target(e, graph_)] = 0;
                    if (FlowVertex const from = boost::source(e, graph_);
                        from < source() && from % 2 == 0 && boost::target(e, graph_) == from + 1) {
                        found.through[from / 2].current += least;
                    }
                }
                way.clear();
                here = gate();
                onPath[here] = 1;
                continue;
            }
            auto const [first, last] = boost::out_edges(here, graph_);
            auto const degree = static_cast<std::size_t>(last - first);
            while (next[here] < degree && flowOf(first[static_cast<std::ptrdiff_t>(next[here])]) <= 0) {
                ++next[here];
            }
            if (next[here] == degree) {
                return; // only the gate can have no flow left: elsewhere the flow out equals the flow in
            }
            Edge const e = first[static_cast<std::ptrdiff_t>(next[here])];
            FlowVertex const to = boost::target(e, graph_);
            way.push_back(e);
            here = to;
            if (onPath[to] != 0) { // a cycle
                auto const start = std::find_if(
                    way.begin(), way.end(), [&](Edge const& x) { return boost::source(x, graph_) == to; });
                Microamperes least = unlimited;
                std::for_each(start, way.end(), [&](Edge x) { least = std::min(least, flowOf(x)); });
                std::for_each(start, way.end(), [&](Edge x) {
                    graph_[x].residual += least;
                    onPath[boost::target(x, graph_)] = 0;
                });
                onPath[to] = 1;
                way.erase(start, way.end());
            }
            onPath[to] = 1;
        }
    }
    [[nodiscard]] Microamperes flowOf(Edge const e) const {
        return graph_[e].capacity == 0 ? 0 : graph_[e].capacity - graph_[e].residual;
    }

    Circuit const& circuit_;
    Graph graph_;
    std::vector<std::uint32_t> order_; // the vertices that can carry current, by id
};

} // namespace

MaxFlow maxFlow(Circuit const& circuit, NetworkMembers const& members, std::string_view network,
                std::span<Microamperes const> capacities) {
    return Network(circuit, members, network, capacities).solve();
}

} // namespace trembler
