#include "physics/electricity/properties/graph.hpp"

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

void setOneWay(ElectricityGraph& row, ObjectId to, CallerCounts const& counts) {
    auto const at = place(row.connections, to);
    bool const there = at != row.connections.end() && at->to == to;
    if (!counts.any()) {
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

CallerCounts connectionBetween(Column<ElectricityGraph> const& graph, ObjectId a, ObjectId b) {
    ElectricityGraph const* const row = graph.find(a);
    if (row == nullptr) {
        return {};
    }
    auto const at = place(row->connections, b);
    return at == row->connections.end() || at->to != b ? CallerCounts{} : at->counts;
}

CallerCounts connectionBetween(Store const& store, ObjectId a, ObjectId b) {
    auto const* const graph = store.findColumn<ElectricityGraph>();
    return graph == nullptr ? CallerCounts{} : connectionBetween(*graph, a, b);
}

void setConnection(Column<ElectricityGraph>& graph, ObjectId a, ObjectId b, CallerCounts const& counts) {
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
