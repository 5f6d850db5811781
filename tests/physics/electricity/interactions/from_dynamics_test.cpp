// (Electricity <- Dynamics): each contact becomes one connection, for any number and times of the
// interaction's turns.
#include "tests/physics/electricity/circuit_world.hpp"

#include <gtest/gtest.h>

namespace trembler::test {
namespace {

void drawSwitch(CircuitWorld& circuit) {
    circuit.source("battery");
    circuit.wire({{"battery", "contact 1"}, {"contact 2", "lamp"}});
    circuit.conductor("switch");
    circuit.store().create("wooden bar");
    circuit.start();
}

std::int32_t contactsBetween(CircuitWorld& circuit, std::string const& a, std::string const& b) {
    return countBy(connectionBetween(circuit.store(), circuit[a], circuit[b]), "Electricity <- Dynamics");
}

TEST(ElectricityContacts, FollowTheThesissFrames) {
    CircuitWorld circuit({.threads = 1, .detail = {}, .periods = {}, .trace = true});
    drawSwitch(circuit);
    circuit.world().step();
    circuit.touch({{"switch", "contact 1"}, {"switch", "contact 2"}});
    circuit.world().step(); // frame f: the switch touches both
    EXPECT_FALSE(circuit.isOn(circuit["lamp"]));
    circuit.world().step(); // frame f + 1: the connections enter the graph, the state turns on
    EXPECT_TRUE(circuit.isOn(circuit["lamp"]));

    Tracer const& tracer = *circuit.world().tracer();
    EventId const on = circuit.state().eventOf(circuit["lamp"]);
    ASSERT_NE(tracer.find(on), nullptr);
    EXPECT_EQ(tracer.find(on)->event, "on");
    EXPECT_EQ(tracer.find(on)->objects, std::vector<std::string>{"lamp"});
    EXPECT_EQ(tracer.find(on)->frame, 3U);
    std::vector<std::string> chain;
    for (EventId const id : tracer.chain(on)) {
        chain.push_back(tracer.find(id)->event);
    }
    EXPECT_EQ(chain, (std::vector<std::string>{"contact begun", "contact begun", "addConnection",
                                               "addConnection", "connected", "connected", "on"}));
    // Each link of the chain names its cause: contact <- call <- connection.
    Event const& connected = *tracer.find(tracer.find(on)->causes.front());
    EXPECT_EQ(connected.objects, (std::vector<std::string>{"contact 1", "switch"}));
    Event const& call = *tracer.find(connected.causes.at(0));
    EXPECT_EQ(call.component, "Electricity <- Dynamics");
    EXPECT_EQ(tracer.find(call.causes.at(0))->event, "contact begun");

    circuit.touch({{"switch", "contact 1"}});
    circuit.world().step();
    circuit.world().step();
    EXPECT_FALSE(circuit.isOn(circuit["lamp"]));
    chain.clear();
    for (EventId const id : tracer.chain(circuit.state().eventOf(circuit["lamp"]))) {
        chain.push_back(tracer.find(id)->event);
    }
    EXPECT_EQ(chain, (std::vector<std::string>{"contact ended", "removeConnection", "disconnected", "off"}));
}

TEST(ElectricityContacts, AWoodenBarDoesNotConnect) {
    CircuitWorld circuit;
    drawSwitch(circuit);
    circuit.touch({{"wooden bar", "contact 1"}, {"wooden bar", "contact 2"}});
    circuit.call({});
    circuit.call({});
    EXPECT_FALSE(circuit.isOn(circuit["lamp"]));
}

TEST(ElectricityContacts, AreNotCountedAgainWhenAppliedForAnotherReason) {
    CircuitWorld circuit;
    drawSwitch(circuit);
    circuit.touch({{"switch", "contact 1"}, {"switch", "contact 2"}});
    circuit.world().step();
    for (int i = 0; i < 5; ++i) { // the slot still contains C_N, because nothing has moved
        circuit.store().column<Conductor>().touch();
        circuit.world().step();
        EXPECT_EQ(contactsBetween(circuit, "switch", "contact 1"), 1);
    }
}

TEST(ElectricityContacts, NoneIsMissedOrLeftOverWithAPeriod) {
    CircuitWorld circuit;
    drawSwitch(circuit);
    circuit.world().setPeriod("Electricity <- Dynamics", 4);
    circuit.world().step(); // frame 1, its turn; then 5, 9, 13
    circuit.touch({{"switch", "contact 1"}});
    circuit.world().step();
    circuit.touch({{"switch", "contact 1"}, {"switch", "contact 2"}});
    circuit.world().step();
    EXPECT_EQ(contactsBetween(circuit, "switch", "contact 1"), 0);
    circuit.call({});
    circuit.call({}); // frame 7
    EXPECT_EQ(contactsBetween(circuit, "switch", "contact 1"), 1);
    EXPECT_TRUE(circuit.isOn(circuit["lamp"]));
    circuit.touch({});
    circuit.world().step();
    circuit.touch({{"switch", "contact 2"}}); // one ended for good, one ended and began between two turns
    circuit.call({});
    circuit.call({});
    EXPECT_EQ(contactsBetween(circuit, "switch", "contact 1"), 0);
    EXPECT_EQ(contactsBetween(circuit, "switch", "contact 2"), 1);
}

TEST(ElectricityContacts, ContactsCountThatExistWhenTheInteractionIsConstructed) {
    CircuitWorld circuit;
    drawSwitch(circuit);
    circuit.touch({{"switch", "contact 1"}, {"switch", "contact 2"}});
    circuit.call({});
    ASSERT_EQ(contactsBetween(circuit, "switch", "contact 1"), 1);
    // Without a provider of contacts the interaction is removed; it is constructed again later.
    ObjectId const director = circuit["director"];
    Touching const touching = circuit.store().column<Touching>()[director];
    circuit.store().column<Touching>().remove(director);
    circuit.call({});
    EXPECT_EQ(circuit.status("Electricity <- Dynamics").activity, Activity::absent);
    Touching half = touching;
    half.pairs.pop_back();
    circuit.store().column<Touching>().set(director, half);
    circuit.call({});
    circuit.call({});
    std::int32_t const one = contactsBetween(circuit, "switch", "contact 1");
    std::int32_t const two = contactsBetween(circuit, "switch", "contact 2");
    EXPECT_EQ(one, 1); // neither counted twice
    EXPECT_EQ(two, 0); // and no connection remains
}

} // namespace
} // namespace trembler::test
