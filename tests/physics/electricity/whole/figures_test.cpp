// The figures of the thesis's Appendix A, edge by edge.
#include "tests/physics/electricity/circuit_world.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace trembler::test {
namespace {

using Names = std::vector<std::string>;

/// The path S-1-...-T and its branches in Figures.
void drawFigure12(CircuitWorld& circuit) {
    circuit.source("S");
    circuit.returning("T");
    circuit.wire(
        {{"S", "1", "2", "3", "4", "5", "T"}, {"1", "6", "3"}, {"1", "10"}, {"5", "7", "8", "9", "7"}});
}

TEST(ElectricityFigures, A5SingleCable) {
    CircuitWorld circuit;
    circuit.source("source");
    circuit.wire({{"source", "1", "2"}, {"1", "3", "4"}, {"5", "6"}, {"7"}});
    circuit.start();
    circuit.world().step();
    EXPECT_EQ(circuit.on(), (Names{"1", "2", "3", "4", "source"}));
    circuit.connect("2", "3"); // no work needs to be done
    EXPECT_EQ(circuit.on(), (Names{"1", "2", "3", "4", "source"}));
    circuit.connect("5", "7"); // nor here
    EXPECT_EQ(circuit.on(), (Names{"1", "2", "3", "4", "source"}));
    circuit.disconnect("5", "7");
    circuit.connect("2", "5"); // the entire subgraph containing object 5
    EXPECT_EQ(circuit.on(), (Names{"1", "2", "3", "4", "5", "6", "source"}));
    EXPECT_NE(circuit.status("Single-cable Electricity").activity, Activity::absent);
    EXPECT_EQ(circuit.status("Two-wire Electricity").activity, Activity::absent);
}

TEST(ElectricityFigures, A6Valve) {
    CircuitWorld circuit;
    circuit.source("tank");
    circuit.wire({{"tank", "1", "2"}, {"1", "3", "4", "5"}});
    circuit.start();
    circuit.world().step();
    EXPECT_TRUE(circuit.isOn(circuit["5"]));
    circuit.disconnect("3", "4");
    EXPECT_EQ(circuit.on(), (Names{"1", "2", "3", "tank"}));
    circuit.connect("3", "4");
    EXPECT_EQ(circuit.on(), (Names{"1", "2", "3", "4", "5", "tank"}));
}

TEST(ElectricityFigures, A7ChainOfDevicesInBothLevels) {
    CircuitWorld circuit(
        {.threads = 1, .detail = {{"electricity", "single-cable"}}, .periods = {}, .trace = false});
    circuit.source("S");
    circuit.returning("T");
    circuit.wire({{"S", "1", "2", "3", "T"}});
    circuit.start();
    circuit.disconnect("2", "3");
    EXPECT_EQ(circuit.on(), (Names{"1", "2", "S"})); // only the objects behind the broken link are off
    circuit.world().setDetail("electricity", "two-wire");
    circuit.world().step();
    EXPECT_EQ(circuit.on(), Names{}); // the entire circuit is off
    circuit.connect("2", "3");
    EXPECT_EQ(circuit.on(), (Names{"1", "2", "3", "S", "T"}));
}

TEST(ElectricityFigures, A8DeadEnds) {
    CircuitWorld circuit;
    circuit.source("S");
    circuit.returning("T");
    circuit.wire({{"S", "1", "2", "3", "T"}, {"2", "4", "6", "5", "4"}, {"S", "7"}, {"T", "8"}});
    circuit.start();
    circuit.world().step();
    EXPECT_EQ(circuit.on(), (Names{"1", "2", "3", "S", "T"}));
    EXPECT_EQ(circuit.status("Single-cable Electricity").activity, Activity::absent);
}

TEST(ElectricityFigures, A12TwoPaths) {
    CircuitWorld circuit;
    drawFigure12(circuit);
    circuit.start();
    circuit.world().step();
    EXPECT_EQ(circuit.on(), (Names{"1", "2", "3", "4", "5", "6", "S", "T"}));
}

// Articulation vertices by their definition: without one, the rest is not connected.
std::set<std::string> articulationVertices(std::map<std::string, std::set<std::string>> const& graph) {
    std::set<std::string> found;
    for (auto const& [taken, unused] : graph) {
        std::set<std::string> reached;
        Names open;
        for (auto const& [name, neighbours] : graph) {
            if (name != taken && open.empty() && reached.empty()) {
                open.push_back(name);
                reached.insert(name);
            }
        }
        while (!open.empty()) {
            std::string const here = open.back();
            open.pop_back();
            for (std::string const& next : graph.at(here)) {
                if (next != taken && reached.insert(next).second) {
                    open.push_back(next);
                }
            }
        }
        if (reached.size() + 1 < graph.size()) {
            found.insert(taken);
        }
    }
    return found;
}

std::map<std::string, std::set<std::string>> graphOf(CircuitWorld& circuit) {
    std::map<std::string, std::set<std::string>> graph;
    auto const& column = circuit.store().column<ElectricityGraph>();
    for (std::size_t r = 0; r < column.size(); ++r) {
        auto& row = graph[circuit.store().nameOf(column.owners()[r])];
        for (auto const& connection : column.values()[r].connections) {
            row.insert(circuit.store().nameOf(connection.to));
        }
    }
    return graph;
}

TEST(ElectricityFigures, A13VirtualEdgeAndArticulationVertices) {
    CircuitWorld circuit;
    drawFigure12(circuit);
    circuit.start();
    circuit.world().step();
    auto graph = graphOf(circuit);
    graph["S"].insert("T"); // the virtual edge, which the world's own graph must not contain
    graph["T"].insert("S");
    EXPECT_EQ(articulationVertices(graph), (std::set<std::string>{"1", "5", "7"}));
    EXPECT_FALSE(connectionBetween(circuit.store(), circuit["S"], circuit["T"]).any());
    // Vertices that articulation vertices cut off from both S and T are off: 10 behind 1; 7 behind 5; 8 and
    // 9.
    EXPECT_EQ(circuit.on(), (Names{"1", "2", "3", "4", "5", "6", "S", "T"}));
}

TEST(ElectricityFigures, A14BrokenConnection) {
    CircuitWorld circuit;
    drawFigure12(circuit);
    circuit.start();
    circuit.world().step();
    circuit.disconnect("3", "4");
    EXPECT_EQ(circuit.on(),
              Names{}); // nothing flows, so source and return are not part of a working circuit either
    EXPECT_EQ(circuit.state().switchedOff.size(), 8U);
    EXPECT_TRUE(circuit.state().switchedOn.empty());
    circuit.connect("4", "3");
    EXPECT_EQ(circuit.on(), (Names{"1", "2", "3", "4", "5", "6", "S", "T"}));
}

TEST(ElectricityFigures, A15And16NaiveSourcesPowerTheLaserFromTheBattery) {
    CircuitWorld circuit;
    circuit.source("1 plant");
    circuit.source("2 battery");
    circuit.returning("T");
    circuit.wire({{"1 plant", "3 laser", "T"}, {"2 battery", "4 flashlight", "T"}});
    circuit.start();
    circuit.world().step();
    EXPECT_EQ(circuit.on(), (Names{"1 plant", "2 battery", "3 laser", "4 flashlight", "T"}));
    circuit.disconnect("1 plant", "3 laser");
    EXPECT_EQ(circuit.on(), (Names{"2 battery", "4 flashlight", "T"}));
    circuit.connect("2 battery", "3 laser");
    EXPECT_TRUE(circuit.isOn(circuit["3 laser"]));
}

TEST(ElectricityFigures, A16SeparateNetworksKeepTheLaserFromTheBattery) {
    CircuitWorld circuit;
    circuit.source("1 plant", "mains");
    circuit.source("2 battery", "battery");
    circuit.conductor("3 laser", "mains");
    circuit.conductor("4 flashlight", "battery");
    circuit.returning("mains return", "mains");
    circuit.returning("battery return", "battery");
    circuit.wire({{"1 plant", "3 laser", "mains return"}, {"2 battery", "4 flashlight", "battery return"}});
    circuit.start();
    circuit.world().step();
    EXPECT_EQ(circuit.on().size(), 6U);
    circuit.disconnect("1 plant", "3 laser");
    EXPECT_EQ(circuit.on(), (Names{"2 battery", "4 flashlight", "battery return"}));
    circuit.connect("2 battery", "3 laser");
    EXPECT_EQ(circuit.on(), (Names{"2 battery", "4 flashlight", "battery return"}));
    // A plain wire takes part in any network: through one, the plant reaches its laser again.
    circuit.call({{circuit["1 plant"], circuit["2 battery"], 0, true}});
    EXPECT_TRUE(circuit.isOn(circuit["3 laser"]));
    EXPECT_TRUE(circuit.isOn(circuit["4 flashlight"]));
}

} // namespace
} // namespace trembler::test
