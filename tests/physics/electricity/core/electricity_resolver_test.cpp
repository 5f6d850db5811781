// Connections are counted for each calling interaction: none removes the connections of another, also when
// interactions are swapped. The scripts of a CircuitWorld are several interactions of one C++ type.
#include "tests/physics/electricity/circuit_world.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

namespace trembler::test {
namespace callers_test {
namespace {

/// battery and lamp, not connected.
void drawLamp(CircuitWorld& circuit) {
    circuit.source("battery");
    circuit.conductor("lamp");
    circuit.start();
    circuit.world().step();
}

CallerCounts between(CircuitWorld& circuit, std::string const& a, std::string const& b) {
    return connectionBetween(circuit.store(), circuit[a], circuit[b]);
}

TEST(ElectricityCallers, NoneRemovesTheConnectionsOfAnother) {
    CircuitWorld circuit;
    drawLamp(circuit);
    circuit.connect("battery", "lamp", 0);
    circuit.disconnect("battery", "lamp", 1);
    circuit.disconnect("battery", "lamp", 2);
    EXPECT_TRUE(circuit.isOn(circuit["lamp"]));
    circuit.connect("battery", "lamp", 1);
    circuit.disconnect("battery", "lamp", 0);
    EXPECT_TRUE(circuit.isOn(circuit["lamp"])) << "the second script still connects them";
    circuit.disconnect("battery", "lamp", 1);
    EXPECT_FALSE(circuit.isOn(circuit["lamp"]));
}

// The connections of a frame are removed from each row of the graph together.
TEST(ElectricityCallers, AddAndRemoveManyConnectionsInOneFrame) {
    EXPECT_TRUE(rc::check([] {
        CircuitWorld circuit;
        constexpr int count = 12;
        std::vector<ObjectId> objects;
        for (int i = 0; i < count; ++i) {
            objects.push_back(circuit.conductor("c" + std::to_string(i)));
        }
        circuit.start();
        std::set<std::pair<int, int>> model; // lower number first
        for (int frame = 0; frame < 4; ++frame) {
            std::vector<Script::Line> lines;
            for (int a = 0; a < count; ++a) {
                for (int b = a + 1; b < count; ++b) {
                    if (*rc::gen::inRange(0, 2) == 0) {
                        continue;
                    }
                    bool const add = !model.contains({a, b});
                    lines.push_back(
                        {objects[static_cast<std::size_t>(a)], objects[static_cast<std::size_t>(b)], 0, add});
                    if (add) {
                        model.insert({a, b});
                    } else {
                        model.erase({a, b});
                    }
                }
            }
            circuit.call(std::move(lines));
            for (int a = 0; a < count; ++a) {
                std::vector<ObjectId> expected;
                for (int b = 0; b < count; ++b) {
                    if (model.contains(std::minmax(a, b))) {
                        expected.push_back(objects[static_cast<std::size_t>(b)]);
                    }
                }
                std::sort(expected.begin(), expected.end());
                std::vector<ObjectId> found;
                for (auto const& connection :
                     circuit.store()
                         .column<ElectricityGraph>()[objects[static_cast<std::size_t>(a)]]
                         .connections) {
                    found.push_back(connection.to);
                }
                RC_ASSERT(found == expected);
            }
        }
    }));
}

TEST(ElectricityCallers, NoneRemovesWiresOfTheLevelAndScissorsCutOnlyThese) {
    CircuitWorld circuit;
    circuit.source("battery");
    circuit.wire({{"battery", "lamp"}});
    circuit.start();
    ObjectId const battery = circuit["battery"];
    ObjectId const lamp = circuit["lamp"];
    circuit.call({{battery, lamp, 0, false}});
    EXPECT_TRUE(circuit.isOn(lamp));
    circuit.touch({{"battery", "lamp"}});
    circuit.call(
        {{battery, lamp, 1, true}, {battery, lamp, scissors, false}, {battery, lamp, scissors, false}});
    EXPECT_TRUE(circuit.isOn(lamp));
    EXPECT_EQ(between(circuit, "battery", "lamp").names(),
              "Electricity <- Dynamics, Electricity <- Script 2");
    circuit.disconnect("battery", "lamp", 1);
    EXPECT_TRUE(circuit.isOn(lamp)) << "they touch";
    circuit.touch({});
    circuit.call({});
    EXPECT_FALSE(circuit.isOn(lamp));
}

TEST(ElectricityCallers, ConnectionsAreRemovedWithTheirCaller) {
    CircuitWorld circuit({.threads = 1, .detail = {}, .periods = {}, .trace = true});
    circuit.source("battery");
    circuit.wire({{"battery", "near"}, {"lamp"}});
    circuit.start();
    circuit.touch({{"near", "battery"}});
    circuit.connect("battery", "lamp", 0);
    circuit.connect("battery", "near", 1);
    ASSERT_TRUE(circuit.isOn(circuit["lamp"]));
    circuit.world().step();
    ASSERT_EQ(circuit.status("Electricity <- Script 1").activity, Activity::asleep);
    ObjectId const director = circuit["director"];
    circuit.store().column<Script>().remove(director); // nothing activates the scripts any more
    circuit.world().step();
    ASSERT_EQ(circuit.status("Electricity <- Script 1").activity, Activity::absent);
    circuit.world().step();
    EXPECT_FALSE(circuit.isOn(circuit["lamp"]));
    EXPECT_EQ(between(circuit, "battery", "near").names(), "level, Electricity <- Dynamics")
        << "the level and the remaining caller";
    auto const& events = circuit.world().tracer()->events();
    EXPECT_TRUE(std::any_of(events.begin(), events.end(), [](Event const& event) {
        return event.event == "disconnected" && event.objects == std::vector<std::string>{"battery", "lamp"};
    }));
    // It is constructed again, without connections.
    circuit.store().column<Script>().set(director, {});
    circuit.world().step();
    circuit.disconnect("battery", "lamp", 0);
    circuit.connect("battery", "lamp", 0);
    EXPECT_EQ(countBy(between(circuit, "battery", "lamp"), 0), 1);
    EXPECT_TRUE(circuit.isOn(circuit["lamp"]));
    circuit.disconnect("battery", "lamp", 0);
    EXPECT_FALSE(circuit.isOn(circuit["lamp"]));
}

TEST(ElectricityCallers, KeepTheirNamesWhileOthersAreAddedAndRemoved) {
    CircuitWorld circuit;
    circuit.source("battery");
    circuit.wire({{"battery", "near"}, {"lamp"}});
    circuit.start();
    circuit.touch({{"near", "lamp"}});
    circuit.connect("battery", "lamp", 2);
    ObjectId const director = circuit["director"];
    // It is registered before the scripts, so the indices of all scripts in the list of callers change.
    circuit.store().column<Touching>().remove(director);
    circuit.world().step();
    ASSERT_EQ(circuit.status("Electricity <- Dynamics").activity, Activity::absent);
    circuit.call({});
    EXPECT_FALSE(between(circuit, "near", "lamp").any())
        << "without contacts being computed, the connection is removed";
    EXPECT_EQ(between(circuit, "battery", "lamp").names(), "Electricity <- Script 3");
    circuit.disconnect("battery", "lamp", 1);
    EXPECT_TRUE(circuit.isOn(circuit["lamp"]));
    circuit.store().column<Touching>().set(director, {});
    circuit.touch({{"near", "lamp"}});
    circuit.call({});
    circuit.call({});
    EXPECT_EQ(between(circuit, "near", "lamp").names(), "Electricity <- Dynamics");
    circuit.disconnect("battery", "lamp", 2);
    EXPECT_FALSE(between(circuit, "battery", "lamp").any()) << "a caller can remove its own connection";
}

TEST(ElectricityCallers, SwappingDetailLevelsChangesNoCount) {
    CircuitWorld circuit;
    circuit.source("battery");
    circuit.wire({{"battery", "lamp"}});
    circuit.start();
    circuit.connect("battery", "lamp", 1);
    std::string const before = between(circuit, "battery", "lamp").names();
    for (char const* level : {"single-cable", "two-wire", "nodal", ""}) {
        circuit.world().setDetail("electricity", level);
        circuit.call({});
        EXPECT_EQ(between(circuit, "battery", "lamp").names(), before) << level;
    }
}

} // namespace
} // namespace callers_test
} // namespace trembler::test
