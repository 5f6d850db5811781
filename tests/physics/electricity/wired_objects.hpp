// Objects and their connections in the columns of electricity, without a world.
#pragma once

#include "physics/electricity/core/circuit.hpp"
#include "physics/electricity/core/netlist.hpp"

#include <string>
#include <utility>

namespace trembler::test {

class WiredObjects {
public:
    /// A vertex of the graph with that id; `network` as in Conductor.
    ObjectId conductor(ObjectId id, std::string const& network = {}) {
        conductors.set(id, {network});
        graph.addDefault(id);
        return id;
    }
    ObjectId conductor(std::uint32_t index, std::string const& network = {}) {
        return conductor(ObjectId{index, 0}, network);
    }
    void connect(ObjectId a, ObjectId b) {
        CallerCounts counts;
        counts.add(CallerId::level(), 1);
        setConnection(graph, a, b, counts);
    }
    [[nodiscard]] ElectricityColumns columns() const { return {graph, conductors, sources, returns}; }
    [[nodiscard]] NodalColumns nodal() const { return {resistances, emfs, ratings, fuses}; }
    /// The circuit of that object; its names are valid as long as this object exists.
    [[nodiscard]] Circuit circuitOf(ObjectId seed) const {
        CircuitWalk walk;
        Circuit circuit;
        walk.begin(columns());
        static_cast<void>(walk.walk(columns(), seed, circuit));
        return circuit;
    }

    Column<ElectricityGraph> graph;
    Column<Conductor> conductors;
    Column<ElectricalSource> sources;
    Column<ElectricalReturn> returns;
    Column<Resistance> resistances;
    Column<Emf> emfs;
    Column<RatedPower> ratings;
    Column<Fuse> fuses;
};

} // namespace trembler::test
