// Flows and bottlenecks in a world.
#include "tests/physics/electricity/nodal_kit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace trembler::test {
namespace flow_test {
namespace {

using Names = std::vector<std::string>;

ObjectId limited(CircuitWorld& circuit, std::string const& name, double ampere) {
    ObjectId const id = circuit[name].valid() ? circuit[name] : circuit.conductor(name);
    circuit.store().column<CurrentCapacity>().set(id, {ampere});
    return id;
}

Names bottleneck(NodalWorld& circuit, std::string const& name) {
    Names names;
    for (ObjectId const id : circuit.circuitOf(name).bottleneck) {
        names.push_back(circuit.store().nameOf(id));
    }
    std::sort(names.begin(), names.end());
    return names;
}

TEST(ElectricityFlow, TheNarrowestPlaceIsTheBottleneck) {
    NodalWorld circuit("flow");
    circuit.source("plus");
    circuit.returning("minus");
    limited(circuit, "thick", 10);
    limited(circuit, "thin", 2);
    limited(circuit, "also thin", 1.5);
    limited(circuit, "off the way", 0.1);
    circuit.wire({{"plus", "thick", "thin", "bar", "minus"},
                  {"thick", "also thin", "bar"},
                  {"bar", "off the way", "dead end"}});
    circuit.begin();
    EXPECT_DOUBLE_EQ(circuit.circuitOf("plus").flow, 3.5);
    EXPECT_EQ(bottleneck(circuit, "plus"), (Names{"also thin", "thin"}));
    EXPECT_DOUBLE_EQ(circuit.at("thick").current, 3.5);
    EXPECT_DOUBLE_EQ(circuit.at("thin").current, 2);
    EXPECT_DOUBLE_EQ(circuit.at("dead end").current, 0);
    EXPECT_FALSE(circuit.isOn(circuit["off the way"]));
    EXPECT_TRUE(circuit.isOn(circuit["thin"]));
    EXPECT_EQ(circuit.circuitOf("plus").level, ElectricalLevel::flow);
    // A second path moves the bottleneck.
    circuit.connect("plus", "bar");
    EXPECT_TRUE(std::isinf(circuit.circuitOf("plus").flow));
    EXPECT_TRUE(circuit.circuitOf("plus").bottleneck.empty());
    limited(circuit, "plus", 7);
    circuit.world().step();
    EXPECT_DOUBLE_EQ(circuit.circuitOf("plus").flow, 7);
    EXPECT_EQ(bottleneck(circuit, "plus"), Names{"plus"});
}

TEST(ElectricityFlow, AnObjectOfZeroCapacityBreaksTheCircuit) {
    NodalWorld circuit("flow");
    circuit.source("plus");
    circuit.returning("minus");
    limited(circuit, "valve", 0);
    circuit.wire({{"plus", "valve", "lamp", "minus"}});
    circuit.begin();
    EXPECT_EQ(circuit.on(), Names{});
    EXPECT_DOUBLE_EQ(circuit.circuitOf("plus").flow, 0);
    limited(circuit, "valve", 1);
    circuit.world().step();
    EXPECT_EQ(circuit.on(), (Names{"lamp", "minus", "plus", "valve"}));
    EXPECT_DOUBLE_EQ(circuit.circuitOf("plus").flow, 1);
}

TEST(ElectricityFlow, AFuseIsACapacityAndABalancedBridgesLampIsOn) {
    NodalWorld circuit("flow");
    circuit.source("plus");
    circuit.returning("minus");
    circuit.fuse("fuse", 3);
    for (char const* const name : {"r1", "r2", "r3", "r4"}) {
        circuit.resistor(name, 10);
    }
    circuit.lamp("lamp", 6, 3);
    circuit.wire(
        {{"plus", "fuse", "r1", "r3", "minus"}, {"fuse", "r2", "r4", "minus"}, {"r1", "lamp", "r2"}});
    circuit.begin();
    EXPECT_DOUBLE_EQ(circuit.circuitOf("plus").flow, 3);
    EXPECT_EQ(bottleneck(circuit, "plus"), Names{"fuse"});
    EXPECT_TRUE(circuit.isOn(circuit["lamp"])); // this level cannot represent a balanced bridge
    circuit.world().setDetail("electricity", "nodal");
    circuit.world().step();
    EXPECT_FALSE(circuit.isOn(circuit["lamp"]));
}

} // namespace
} // namespace flow_test
} // namespace trembler::test
