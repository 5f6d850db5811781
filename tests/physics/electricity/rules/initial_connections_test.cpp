// Counting of connections, the objects that may have them, and their history in a trace.
#include "tests/physics/electricity/circuit_world.hpp"
#include "tests/support/initial_wire.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace trembler::test {
namespace {

WorldOptions traced() {
    return {.threads = 1, .detail = {}, .periods = {}, .trace = true};
}

/// battery, switch and lamp, with a wire from battery to switch.
void drawOneLamp(CircuitWorld& circuit) {
    circuit.source("battery");
    circuit.wire({{"battery", "switch"}, {"lamp"}});
    circuit.start();
}

TEST(ElectricityConnections, AreCountedByCaller) {
    CircuitWorld circuit;
    drawOneLamp(circuit);
    circuit.connect("switch", "lamp", 1);
    circuit.connect("lamp", "switch", 0); // the order of the two does not matter
    CallerCounts both = connectionBetween(circuit.store(), circuit["switch"], circuit["lamp"]);
    EXPECT_EQ(countBy(both, 1), 1);
    EXPECT_EQ(countBy(both, 0), 1);
    EXPECT_EQ(countBy(both, 2), 0);
    circuit.disconnect("switch", "lamp", 1);
    EXPECT_TRUE(circuit.isOn(circuit["lamp"])); // the wire remains
    circuit.disconnect("switch", "lamp", 0);
    EXPECT_FALSE(circuit.isOn(circuit["lamp"]));
    EXPECT_FALSE(connectionBetween(circuit.store(), circuit["switch"], circuit["lamp"]).any());
}

TEST(ElectricityConnections, RemovingAMissingOneDoesNotAffectALaterOne) {
    CircuitWorld circuit;
    drawOneLamp(circuit);
    circuit.disconnect("switch", "lamp");
    circuit.disconnect("switch", "lamp");
    circuit.connect("switch", "lamp");
    EXPECT_TRUE(circuit.isOn(circuit["lamp"]));
    EXPECT_EQ(countBy(connectionBetween(circuit.store(), circuit["switch"], circuit["lamp"]), 0), 1);
}

TEST(ElectricityConnections, DoNotDependOnTheOrderOfCallsInAFrame) {
    std::vector<int> order{0, 1, 2, 3, 4};
    std::vector<std::uint64_t> hashes;
    do {
        CircuitWorld circuit;
        drawOneLamp(circuit);
        ObjectId const a = circuit["switch"];
        ObjectId const b = circuit["lamp"];
        std::vector<Script::Line> const lines{
            {a, b, 0, true}, {a, b, 0, false}, {b, a, 0, false}, {b, a, 0, true}, {a, b, 0, true}};
        std::vector<Script::Line> shuffled;
        for (int const i : order) {
            shuffled.push_back(lines[static_cast<std::size_t>(i)]);
        }
        circuit.call(shuffled);
        EXPECT_EQ(countBy(connectionBetween(circuit.store(), a, b), 0), 1);
        hashes.push_back(circuit.world().stateHash());
    } while (std::next_permutation(order.begin(), order.end()));
    EXPECT_EQ(hashes.size(), 120U);
    EXPECT_EQ(std::count(hashes.begin(), hashes.end(), hashes.front()), 120);
}

TEST(ElectricityConnections, ArePartOfTheStateHash) {
    CircuitWorld circuit;
    drawOneLamp(circuit);
    circuit.call({});
    std::uint64_t const open = circuit.world().stateHash();
    circuit.connect("switch", "lamp");
    std::uint64_t const closed = circuit.world().stateHash();
    circuit.connect("switch", "lamp"); // one more: no object's state changes, but the world's does
    EXPECT_NE(circuit.world().stateHash(), closed);
    circuit.disconnect("switch", "lamp");
    EXPECT_EQ(circuit.world().stateHash(), closed);
    circuit.disconnect("switch", "lamp");
    EXPECT_EQ(circuit.world().stateHash(), open);
}

TEST(ElectricityConnections, NonConductorsNeverEnter) {
    CircuitWorld circuit;
    ObjectId const wood = circuit.store().create("wood");
    drawOneLamp(circuit);
    circuit.call({{wood, circuit["battery"], 1, true},
                  {circuit["lamp"], wood, 1, true},
                  {circuit["lamp"], circuit["lamp"], 1, true}});
    EXPECT_FALSE(circuit.store().column<ElectricityGraph>().has(wood));
    EXPECT_FALSE(circuit.isOn(circuit["lamp"]));
    EXPECT_TRUE(circuit.store().column<ElectricityGraph>()[circuit["lamp"]].connections.empty());
}

TEST(ElectricityConnections, ThePlayerCutsOneWireAtATimeAndNoContact) {
    CircuitWorld circuit(traced());
    circuit.source("battery");
    circuit.wire({{"battery", "switch", "lamp"}, {"lamp", "switch"}}); // two wires between switch and lamp
    circuit.start();
    circuit.world().step();
    auto const cut = [&] {
        circuit.world().feed({.kind = PlayerInput::Kind::cut,
                              .object = circuit["lamp"],
                              .other = circuit["switch"],
                              .at = {}});
        circuit.call({});
    };
    cut();
    EXPECT_TRUE(circuit.isOn(circuit["lamp"]));
    cut();
    EXPECT_FALSE(circuit.isOn(circuit["lamp"]));
    circuit.connect("switch", "lamp", 1);
    cut();
    EXPECT_TRUE(circuit.isOn(circuit["lamp"]));
    // The cut is the cause of the lamp's going off.
    auto const events = circuit.world().tracer()->events();
    auto const off =
        std::find_if(events.begin(), events.end(), [](Event const& e) { return e.event == "off"; });
    ASSERT_NE(off, events.end());
    EXPECT_EQ(off->objects, std::vector<std::string>{"lamp"});
    std::vector<std::string> chain;
    for (EventId const id : circuit.world().tracer()->chain(off->id)) {
        chain.push_back(circuit.world().tracer()->find(id)->event);
    }
    EXPECT_EQ(chain, (std::vector<std::string>{"cut", "cutWire", "disconnected", "off"}));
}

TEST(ElectricityConnections, InvalidInitialOnesAreRefusedWithAMessage) {
    CircuitWorld circuit;
    ObjectId const wood = circuit.store().create("wood");
    ObjectId const steel = circuit.conductor("steel");
    ObjectId const iron = circuit.conductor("iron");
    EXPECT_NE(connectInitially(circuit.store(), steel, wood)->find("'wood' is no conductor"),
              std::string::npos);
    EXPECT_NE(connectInitially(circuit.store(), steel, steel)->find("itself"), std::string::npos);
    EXPECT_TRUE(connectInitially(circuit.store(), steel, ObjectId{}).has_value());
    EXPECT_EQ(circuit.store().column<ElectricityGraph>().size(), 0U);
    EXPECT_EQ(connectInitially(circuit.store(), steel, iron), std::nullopt);
    EXPECT_EQ(connectInitially(circuit.store(), iron, steel), std::nullopt);
    EXPECT_EQ(connectionBetween(circuit.store(), steel, iron).of(CallerId::level()), 2);
}

TEST(ElectricityConnections, TerminalsMustConductAndBelongToTheirNetwork) {
    Registry registry;
    registerElectricity(registry);
    CircuitWorld circuit;
    ObjectId const good = circuit.source("good", "mains");
    ObjectId const made = circuit.conductor("made for batteries", "battery");
    circuit.store().column<ElectricalSource>().set(made, {"mains"});
    ObjectId const wood = circuit.store().create("wood");
    circuit.store().column<ElectricalSource>().set(wood, {});
    auto const rule = std::find_if(registry.rules().begin(), registry.rules().end(), [](ObjectRule const& r) {
        return r.property == &propertyInfo<ElectricalSource>();
    });
    ASSERT_NE(rule, registry.rules().end());
    EXPECT_EQ(rule->check(circuit.store(), good), std::nullopt);
    EXPECT_NE(rule->check(circuit.store(), made)->find("network 'battery'"), std::string::npos);
    EXPECT_NE(rule->check(circuit.store(), wood)->find("no conductor"), std::string::npos);
}

} // namespace
} // namespace trembler::test
