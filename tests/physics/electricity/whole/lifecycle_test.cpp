// Sleeping, swapping, threads, created and destroyed objects, and size.
#include "physics/electricity/core/graph_changes.hpp"
#include "tests/physics/electricity/circuit_world.hpp"
#include "tests/support/initial_wire.hpp"
#include "tests/support/sanitizer.hpp"

#include <gtest/gtest.h>

#include <random>

namespace trembler::test {
namespace {

using Names = std::vector<std::string>;

TEST(ElectricityLifecycle, AFinishedCircuitSleeps) {
    CircuitWorld circuit;
    circuit.source("battery");
    circuit.wire({{"battery", "lamp", "end"}});
    circuit.start();
    circuit.connect("battery", "end");
    circuit.call({});
    std::uint64_t const updates = circuit.status("Single-cable Electricity").updates;
    std::uint64_t const number = circuit.world().find<GraphChanges>()->number;
    for (int i = 0; i < 10; ++i) {
        circuit.world().step();
    }
    EXPECT_EQ(circuit.status("Single-cable Electricity").updates, updates);
    EXPECT_EQ(circuit.status("Single-cable Electricity").activity, Activity::asleep);
    EXPECT_EQ(circuit.status("Electricity").activity, Activity::asleep);
    EXPECT_EQ(circuit.status("Electricity <- Dynamics").activity, Activity::asleep);
    EXPECT_EQ(circuit.world().find<GraphChanges>()->number, number);
}

TEST(ElectricityLifecycle, ChangesWithoutEffectOnStatesWakeNoReader) {
    CircuitWorld circuit;
    circuit.source("battery");
    circuit.wire({{"battery", "lamp"}, {"a"}, {"b"}});
    circuit.start();
    circuit.call({});
    std::uint64_t const version = circuit.store().slot<ElectricalState>().version();
    circuit.connect("a", "b"); // two objects that are off
    EXPECT_EQ(circuit.store().slot<ElectricalState>().version(), version);
    circuit.connect("battery", "a");
    EXPECT_NE(circuit.store().slot<ElectricalState>().version(), version);
    EXPECT_EQ(circuit.state().switchedOn, (std::vector{circuit["a"], circuit["b"]}));
}

TEST(ElectricityLifecycle, SwitchedListsAreExactAfterASwapOfTheLevel) {
    CircuitWorld circuit;
    circuit.source("S");
    circuit.returning("T");
    circuit.wire({{"S", "1", "2", "T"}, {"2", "dead end"}});
    circuit.start();
    circuit.world().step();
    EXPECT_EQ(circuit.on(), (Names{"1", "2", "S", "T"}));
    circuit.world().setDetail("electricity", "single-cable");
    circuit.world().step();
    EXPECT_EQ(circuit.state().switchedOn, std::vector{circuit["dead end"]});
    EXPECT_TRUE(circuit.state().switchedOff.empty());
    EXPECT_EQ(circuit.state().frame, circuit.world().frame());
    circuit.world().setDetail("electricity", "two-wire");
    circuit.world().step();
    EXPECT_EQ(circuit.state().switchedOff, std::vector{circuit["dead end"]});
    EXPECT_TRUE(circuit.state().switchedOn.empty());
}

TEST(ElectricityLifecycle, LosingTheLastReturnLightsNothing) {
    CircuitWorld circuit;
    circuit.source("S");
    circuit.returning("T");
    circuit.wire({{"S", "lamp", "T"}, {"S", "spare"}});
    circuit.start();
    circuit.world().step();
    ASSERT_TRUE(circuit.isOn(circuit["lamp"]));
    circuit.call({}, {circuit["T"]});
    EXPECT_EQ(circuit.on(), Names{}); // not all of them, as in a world with cables only
    EXPECT_EQ(circuit.state().switchedOff, (std::vector{circuit["S"], circuit["lamp"]}));
}

TEST(ElectricityLifecycle, ConnectionsAreRemovedWithTheirObjects) {
    CircuitWorld circuit;
    circuit.source("battery");
    circuit.wire({{"battery", "bridge", "lamp"}});
    circuit.start();
    circuit.world().step();
    ASSERT_TRUE(circuit.isOn(circuit["lamp"]));
    ObjectId const bridge = circuit["bridge"];
    circuit.world().feed({.kind = PlayerInput::Kind::remove, .object = bridge, .other = {}, .at = {}});
    circuit.call({});
    EXPECT_FALSE(circuit.store().alive(bridge));
    EXPECT_FALSE(circuit.isOn(circuit["lamp"]));
    EXPECT_FALSE(circuit.isOn(bridge));
    EXPECT_TRUE(circuit.store().column<ElectricityGraph>()[circuit["lamp"]].connections.empty());
    // The next object with the same index has none of its connections.
    Prototype plain{"bar", {}};
    plain.values.push_back(std::make_unique<ValueOf<Conductor>>());
    std::uint32_t const bar = circuit.store().prototypes().add(std::move(plain));
    circuit.call({}, {},
                 {{.prototype = bar,
                   .position = {},
                   .angle = 0,
                   .velocity = {},
                   .spin = 0,
                   .maker = circuit["lamp"],
                   .number = 0}});
    ObjectId const born = circuit["bar of lamp 0"];
    ASSERT_TRUE(born.valid());
    EXPECT_EQ(born.index, bridge.index);
    EXPECT_FALSE(circuit.isOn(born));
    circuit.call({{circuit["battery"], born, 1, true}});
    EXPECT_TRUE(circuit.isOn(born));
    EXPECT_FALSE(circuit.isOn(bridge));
}

TEST(ElectricityLifecycle, ChangedRolesInNetworksSwitchOtherObjects) {
    CircuitWorld circuit;
    circuit.source("S", "mains");
    circuit.returning("T", "mains");
    circuit.wire({{"S", "lamp", "T"}});
    circuit.start();
    circuit.world().step();
    ASSERT_EQ(circuit.on(), (Names{"S", "T", "lamp"}));
    circuit.store().column<Conductor>().set(circuit["lamp"], {"battery"});
    circuit.world().step();
    EXPECT_EQ(circuit.on(), Names{});
    circuit.store().column<Conductor>().set(circuit["lamp"], {"mains"});
    circuit.world().step();
    EXPECT_EQ(circuit.on(), (Names{"S", "T", "lamp"}));
    circuit.store().column<ElectricalReturn>().set(circuit["T"], {"battery"});
    circuit.world().step();
    EXPECT_EQ(circuit.on(), Names{});
    circuit.store().column<ElectricalReturn>().set(circuit["T"], {"mains"});
    circuit.store().column<ElectricalSource>().remove(circuit["S"]);
    circuit.world().step();
    EXPECT_EQ(circuit.on(), Names{});
    circuit.store().column<ElectricalSource>().set(circuit["lamp"], {"mains"});
    circuit.world().step();
    EXPECT_EQ(circuit.on(), (Names{"T", "lamp"}));
}

TEST(ElectricityLifecycle, AWireStraightFromSourceToReturnAndOneThatIsBoth) {
    CircuitWorld circuit;
    circuit.source("S");
    circuit.returning("T");
    circuit.source("both");
    circuit.store().column<ElectricalReturn>().set(circuit["both"], {});
    circuit.wire({{"S", "T"}, {"both", "a", "b", "both"}, {"S", "tail"}});
    circuit.start();
    circuit.world().step();
    // A loop that starts and ends at the same object uses that object twice.
    EXPECT_EQ(circuit.on(), (Names{"S", "T", "both"}));
    circuit.disconnect("S", "T");
    EXPECT_EQ(circuit.on(), Names{"both"});
}

std::vector<std::uint64_t> hashesWith(int threads, std::vector<bool>& states) {
    constexpr int count = 6000; // enough rows for several threads
    CircuitWorld circuit({.threads = threads, .detail = {}, .periods = {}, .trace = false});
    std::vector<ObjectId> ids;
    for (int i = 0; i < count; ++i) {
        std::string const name = "object " + std::to_string(i);
        ids.push_back(i % 50 == 0   ? circuit.source(name)
                      : i % 50 == 1 ? circuit.returning(name)
                                    : circuit.conductor(name));
    }
    circuit.start();
    std::mt19937 random(1); // the generator is the same in every standard library; distributions are not
    std::vector<std::uint64_t> hashes;
    for (int frame = 0; frame < 30; ++frame) {
        std::vector<Script::Line> lines;
        for (int i = 0; i < 400; ++i) {
            auto const a = static_cast<std::size_t>(random() % count);
            std::size_t const b = (a + 1 + random() % 40) % count;
            lines.push_back({ids[a], ids[b], random() % scripts, random() % 4 != 0});
        }
        std::vector<ObjectId> destroys;
        if (frame % 5 == 4) {
            destroys.push_back(ids[random() % count]);
        }
        circuit.write(lines, destroys);
        circuit.world().step();
        hashes.push_back(circuit.world().stateHash());
        for (ObjectId const id : ids) {
            states.push_back(circuit.isOn(id));
        }
    }
    return hashes;
}

TEST(ElectricityLifecycle, IsTheSameForAnyNumberOfThreads) {
    std::vector<bool> states;
    std::vector<std::uint64_t> const hashes = hashesWith(1, states);
    EXPECT_GT(std::count(states.begin(), states.end(), true), 1000);
    EXPECT_GT(std::count(states.begin(), states.end(), false), 1000);
    for (int const threads : {2, 3, 8}) {
        std::vector<bool> others;
        EXPECT_EQ(hashesWith(threads, others), hashes) << threads << " threads";
        EXPECT_EQ(others, states) << threads << " threads";
    }
}

TEST(ElectricityLifecycle, AChainOfAMillionObjects) {
    constexpr std::size_t count = test::underSanitizer ? 100000 : 1000000;
    CircuitWorld circuit;
    std::vector<ObjectId> chain;
    chain.push_back(circuit.source("S"));
    for (std::size_t i = 1; i + 1 < count; ++i) {
        chain.push_back(circuit.conductor(std::to_string(i)));
    }
    chain.push_back(circuit.returning("T"));
    for (std::size_t i = 1; i < count; ++i) {
        ASSERT_EQ(connectInitially(circuit.store(), chain[i - 1], chain[i]), std::nullopt);
    }
    circuit.start();
    circuit.world().step();
    EXPECT_EQ(circuit.state().switchedOn.size(), count);
    Script::Line middle{chain[count / 2], chain[count / 2 + 1], scissors, false};
    circuit.call({middle});
    EXPECT_EQ(circuit.state().switchedOff.size(), count);
    EXPECT_FALSE(circuit.isOn(chain.front()));
    circuit.world().setDetail("electricity", "single-cable");
    circuit.world().step();
    EXPECT_EQ(circuit.state().switchedOn.size(), count / 2 + 1);
    EXPECT_TRUE(circuit.isOn(chain[count / 2]));
    EXPECT_FALSE(circuit.isOn(chain[count / 2 + 1]));
    circuit.world().setDetail("electricity", "two-wire");
    middle.script = 0;
    middle.add = true;
    circuit.call({middle});
    EXPECT_TRUE(circuit.isOn(chain.back()));
    EXPECT_TRUE(circuit.isOn(chain[count / 2]));
}

TEST(ElectricityLifecycle, RegistersThePropertiesOfLevelFiles) {
    Registry registry;
    registerRuntime(registry);
    registerElectricity(registry);
    EXPECT_NO_THROW(registry.check());
    EXPECT_EQ(registry.connectionKinds(), std::vector<std::string>{"wire"});
    for (std::string_view const key :
         {"conductor", "electrical_source", "electrical_return", "electrical_device"}) {
        ASSERT_NE(registry.objectProperty(key), nullptr) << key;
        EXPECT_EQ(registry.objectProperty(key)->text.place, PropertyPlace::properties) << key;
    }
    EXPECT_EQ(registry.objectProperty("electricity_graph")->text.place, PropertyPlace::hidden);
}

} // namespace
} // namespace trembler::test
