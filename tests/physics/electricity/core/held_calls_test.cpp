// Connections and voltages that interactions hold, in worlds whose calls are scripted.
#include "tests/physics/electricity/nodal_kit.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace trembler::test {
namespace {

CallerCounts heldBetween(CircuitWorld& circuit, std::string const& a, std::string const& b) {
    return connectionBetween(circuit.store(), circuit[a], circuit[b]);
}

void drawBatteryAndLamp(CircuitWorld& circuit) {
    circuit.source("battery");
    circuit.conductor("lamp");
    circuit.start();
    circuit.world().step();
}

TEST(HeldCalls, ConnectForAsLongAsTheyAreHeld) {
    CircuitWorld circuit;
    drawBatteryAndLamp(circuit);
    Holding::Connection const here{circuit["battery"], circuit["lamp"], 0};
    circuit.hold({.connections = {here}, .voltages = {}});
    EXPECT_TRUE(circuit.isOn(circuit["lamp"]));
    for (int frame = 0; frame < 5; ++frame) {
        circuit.world().step();
    }
    EXPECT_EQ(countBy(heldBetween(circuit, "battery", "lamp"), 0), 1) << "once, not once in each frame";
    circuit.hold({});
    EXPECT_FALSE(circuit.isOn(circuit["lamp"]));
    EXPECT_FALSE(heldBetween(circuit, "battery", "lamp").any());
}

TEST(HeldCalls, OfOneCallerOnOnePairAreOneConnectionWhicheverWayRound) {
    CircuitWorld circuit;
    drawBatteryAndLamp(circuit);
    ObjectId const battery = circuit["battery"];
    ObjectId const lamp = circuit["lamp"];
    circuit.hold(
        {.connections = {{battery, lamp, 0}, {lamp, battery, 0}, {battery, lamp, 0}}, .voltages = {}});
    EXPECT_EQ(countBy(heldBetween(circuit, "battery", "lamp"), 0), 1);
    circuit.connect("battery", "lamp", 0);
    EXPECT_EQ(countBy(heldBetween(circuit, "battery", "lamp"), 0), 2) << "what is added counts besides";
    circuit.hold({});
    EXPECT_EQ(countBy(heldBetween(circuit, "battery", "lamp"), 0), 1);
    EXPECT_TRUE(circuit.isOn(lamp));
}

// 5.7.2: in one frame the first cause ends and the second begins.
TEST(HeldCalls, TwoCausesOfOneConnectionTakeTurnsWithoutABreak) {
    CircuitWorld circuit({.threads = 1, .detail = {}, .periods = {}, .trace = true});
    drawBatteryAndLamp(circuit);
    ObjectId const battery = circuit["battery"];
    ObjectId const lamp = circuit["lamp"];
    circuit.hold({.connections = {{battery, lamp, 0}}, .voltages = {}});
    for (std::size_t script : {1U, 0U, 2U}) {
        circuit.hold({.connections = {{battery, lamp, script}}, .voltages = {}});
        EXPECT_TRUE(circuit.isOn(lamp));
        EXPECT_EQ(heldBetween(circuit, "battery", "lamp").names(),
                  "Electricity <- Script " + std::to_string(script + 1));
    }
    auto const& events = circuit.world().tracer()->events();
    EXPECT_TRUE(std::none_of(events.begin(), events.end(),
                             [](Event const& event) { return event.event == "disconnected"; }));
}

TEST(HeldCalls, EndWithTheirObject) {
    CircuitWorld circuit;
    drawBatteryAndLamp(circuit);
    ObjectId const lamp = circuit["lamp"];
    circuit.hold({.connections = {{circuit["battery"], lamp, 0}}, .voltages = {}});
    circuit.call({}, {lamp});
    EXPECT_FALSE(circuit.store().alive(lamp));
    circuit.conductor("another lamp"); // it may have the index of the first
    circuit.hold({.connections = {{circuit["battery"], circuit["another lamp"], 0}}, .voltages = {}});
    EXPECT_TRUE(circuit.isOn(circuit["another lamp"]));
    circuit.hold({});
    EXPECT_FALSE(circuit.isOn(circuit["another lamp"]));
}

TEST(HeldCalls, EndWithTheirCallerAndBeginWithItAgain) {
    CircuitWorld circuit;
    drawBatteryAndLamp(circuit);
    circuit.hold({.connections = {{circuit["battery"], circuit["lamp"], 1}}, .voltages = {}});
    ObjectId const director = circuit["director"];
    circuit.store().column<Script>().remove(director); // nothing activates the scripts any more
    circuit.world().step();
    circuit.world().step();
    EXPECT_FALSE(circuit.isOn(circuit["lamp"]));
    circuit.store().column<Script>().set(director, {});
    for (int frame = 0; frame < 3; ++frame) {
        circuit.world().step();
    }
    EXPECT_EQ(countBy(heldBetween(circuit, "battery", "lamp"), 1), 1);
    EXPECT_TRUE(circuit.isOn(circuit["lamp"]));
}

TEST(HeldCalls, DoNotPassAFuseThatHasBlown) {
    NodalWorld circuit;
    circuit.battery("plus", 10);
    circuit.fuse("fuse", 1);
    circuit.resistor("load", 5);
    circuit.returning("minus");
    circuit.wire({{"fuse", "load", "minus"}});
    circuit.begin();
    circuit.hold({.connections = {{circuit["plus"], circuit["fuse"], 0}}, .voltages = {}}); // 2 A
    for (int frame = 0; frame < 5; ++frame) {
        circuit.world().step();
    }
    EXPECT_FALSE(heldBetween(circuit, "plus", "fuse").any());
    EXPECT_NEAR(circuit.at("load").current, 0, 1e-12);
}

TEST(HeldCalls, VoltagesAddUpToTheEmfOfASource) {
    NodalWorld circuit;
    circuit.battery("coil", 0, 2);
    circuit.battery("battery", 6, 0, "another");
    circuit.resistor("load", 8);
    circuit.returning("minus");
    circuit.wire({{"coil", "load", "minus"}});
    circuit.begin();
    EXPECT_NEAR(circuit.at("load").current, 0, 1e-12);
    ObjectId const coil = circuit["coil"];
    circuit.hold({.connections = {}, .voltages = {{coil, 7, 0}, {coil, 1, 0}, {coil, -3, 1}}});
    EXPECT_NEAR(circuit.at("load").current, 5.0 / (2 + 8), 1e-12) << "(7 + 1 - 3) V over both resistances";
    EXPECT_TRUE(circuit.isOn(circuit["load"]));
    circuit.hold({.connections = {}, .voltages = {{coil, -4, 2}}});
    EXPECT_NEAR(circuit.at("coil").potential, -4 * 8.0 / (2 + 8), 1e-12) << "it may be negative";
    circuit.hold({.connections = {}, .voltages = {{circuit["load"], 4, 2}}});
    EXPECT_NEAR(circuit.at("load").current, 0, 1e-12) << "only a source with an EMF can be raised";
    EXPECT_NEAR(circuit.at("battery").potential, 6, 1e-12);
}

} // namespace
} // namespace trembler::test
