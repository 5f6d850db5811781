#include "physics/electricity/initial_connections.hpp"

#include "physics/electricity/graph.hpp"
#include "physics/electricity/properties.hpp"
#include "runtime/world/store.hpp"

#include <fmt/format.h>

namespace trembler {

std::optional<std::string> connectInitially(Store& store, ObjectId a, ObjectId b) {
    auto const& conductors = store.column<Conductor>();
    for (ObjectId const id : {a, b}) {
        if (!store.alive(id)) {
            return "one end of the connection is no object; expected two objects that conduct electricity";
        }
        if (!conductors.has(id)) {
            return fmt::format("'{}' is no conductor; expected two objects with the property '{}'",
                               store.nameOf(id), Conductor::text.key);
        }
    }
    if (a == b) {
        return fmt::format("'{}' is connected to itself; expected two different objects", store.nameOf(a));
    }
    auto& graph = store.column<ElectricityGraph>();
    if (!graph.has(a) || !graph.has(b)) {
        addVertices(graph, conductors.owners()); // all at once, in order: one by one would be quadratic
    }
    ConnectionCounts counts = connectionBetween(graph, a, b);
    ++counts.of(ConnectionCause::wire);
    setConnection(graph, a, b, counts);
    return std::nullopt;
}

} // namespace trembler
