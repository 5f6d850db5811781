#include "physics/electricity/rules/initial_connections.hpp"

#include "physics/electricity/properties/graph.hpp"
#include "physics/electricity/rules/completion.hpp"
#include "runtime/property/for_each.hpp"

namespace trembler {

void layWire(Store& store, ObjectId a, ObjectId b) {
    auto& conductors = store.column<Conductor>();
    if (!conductors.has(a) || !conductors.has(b)) {
        // Objects conduct because of their material, but completions run later. So all of them are made
        // conductors here, at once: one by one would be quadratic.
        auto const& without = store.column<Without>();
        std::vector<ObjectId> metal;
        forEach(
            [&](ObjectId id, MadeOf const& of) {
                if (!conductors.has(id) && conductsByMaterial(&of, without.find(id))) {
                    metal.push_back(id);
                }
            },
            store.column<MadeOf>());
        conductors.addMany(metal, std::vector<Conductor>(metal.size()));
    }
    auto& graph = store.column<ElectricityGraph>();
    if (!graph.has(a) || !graph.has(b)) {
        // All at once, in order: one by one would be quadratic.
        addVertices(graph, conductors.owners());
    }
    CallerCounts counts = connectionBetween(graph, a, b);
    counts.add(CallerId::level(), 1);
    setConnection(graph, a, b, counts);
}

} // namespace trembler
