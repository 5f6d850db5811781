#include "physics/electricity/graph.hpp"

#include "runtime/world/store.hpp"

#include <algorithm>

namespace trembler {
namespace {

using Connection = ElectricityGraph::Connection;

template <class Connections>
auto place(Connections& connections, ObjectId to) {
    return std::lower_bound(connections.begin(), connections.end(), to,
                            [](Connection const& connection, ObjectId id) { return connection.to < id; });
}

void setOneWay(ElectricityGraph& row, ObjectId to, ConnectionCounts const& counts) {
    auto const at = place(row.connections, to);
    bool const there = at != row.connections.end() && at->to == to;
    if (!counts.connected()) {
        if (there) {
            row.connections.erase(at);
        }
    } else if (there) {
        at->counts = counts;
    } else {
        row.connections.insert(at, {to, counts});
    }
}

} // namespace

ConnectionCounts connectionBetween(Column<ElectricityGraph> const& graph, ObjectId a, ObjectId b) {
    ElectricityGraph const* const row = graph.find(a);
    if (row == nullptr) {
        return {};
    }
    auto const at = place(row->connections, b);
    return at == row->connections.end() || at->to != b ? ConnectionCounts{} : at->counts;
}

ConnectionCounts connectionBetween(Store const& store, ObjectId a, ObjectId b) {
    auto const* const graph = store.findColumn<ElectricityGraph>();
    return graph == nullptr ? ConnectionCounts{} : connectionBetween(*graph, a, b);
}

void setConnection(Column<ElectricityGraph>& graph, ObjectId a, ObjectId b, ConnectionCounts const& counts) {
    assert(a != b);
    setOneWay(graph[a], b, counts);
    setOneWay(graph[b], a, counts);
    graph.touch();
}

void addVertices(Column<ElectricityGraph>& graph, std::span<ObjectId const> vertices) {
    for (ObjectId const id : vertices) {
        graph.addDefault(id);
    }
}

} // namespace trembler
