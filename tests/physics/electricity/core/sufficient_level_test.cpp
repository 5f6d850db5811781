// The detail level that a scene, and each of its circuits, gets by default; and circuits that cheaper levels
// cannot represent.
#include "physics/electricity/core/sufficient_level.hpp"
#include "tests/physics/electricity/nodal_kit.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace trembler::test {
namespace {

std::string levelAtWork(CircuitWorld& circuit) {
    std::string level;
    for (ComponentStatus const& status : circuit.world().status()) {
        if (status.info->text.effect == "electricity" && !status.info->text.level.empty() &&
            status.activity != Activity::absent) {
            level += status.info->text.level;
        }
    }
    return level;
}

void drawCircuit(NodalWorld& circuit, std::string const& suffix, bool returning = true) {
    circuit.source("plus" + suffix);
    if (returning) {
        circuit.returning("minus" + suffix);
    }
    circuit.wire({{"plus" + suffix, "lamp" + suffix, "minus" + suffix}});
}

TEST(ElectricitySufficientLevel, IsTheCheapestThatCanRepresentTheScene) {
    NodalWorld cable;
    drawCircuit(cable, "", false);
    cable.begin();
    EXPECT_EQ(levelAtWork(cable), "single-cable");
    EXPECT_TRUE(whyElectricalLevel(cable.store()).starts_with("single-cable: there never was a return"));

    NodalWorld wires;
    drawCircuit(wires, "");
    wires.begin();
    EXPECT_EQ(levelAtWork(wires), "two-wire");
    EXPECT_TRUE(wires.quantities().byIndex.empty());
    EXPECT_TRUE(whyElectricalLevel(wires.store()).starts_with("two-wire: nothing has a resistance"));

    struct Case {
        char const* words;
        void (*give)(Store&, ObjectId);
    };
    for (Case const &one :
         {Case{"a resistance", [](Store&s, ObjectId id) { s.column<Resistance>().set(id, {3}); }},
          Case{"an EMF",
               [](Store&s, ObjectId id) {
                   s.column<Emf>().set(id, {9, 1});
               }},
          Case{"a rated power",
               [](Store&s, ObjectId id) {
                   s.column<RatedPower>().set(id, {3, 6});
               }},
          Case{"a fuse", [](Store&s, ObjectId id) {
                   s.column<Fuse>().set(id, {3, false});
               }}}) {
        NodalWorld circuit;
        drawCircuit(circuit, "");
        one.give(circuit.store(), circuit["plus"]);
        circuit.begin();
        EXPECT_EQ(levelAtWork(circuit), "nodal") << one.words;
        EXPECT_TRUE(whyElectricalLevel(circuit.store())
                        .starts_with("nodal, because 'plus' has " + std::string(one.words)))
            << whyElectricalLevel(circuit.store());
    }
}

TEST(ElectricitySufficientLevel, WithoutAReturnItIsSingleCableForAnyOtherProperties) {
    NodalWorld circuit;
    circuit.battery("plus", 9);
    circuit.lamp("lamp", 6, 3);
    circuit.wire({{"plus", "lamp"}});
    circuit.begin();
    EXPECT_EQ(levelAtWork(circuit), "single-cable");
    EXPECT_TRUE(circuit.isOn(circuit["lamp"]));
    // A stated level nodal gives the same result, because there is no return for a current.
    circuit.world().setDetail("electricity", "nodal");
    circuit.world().step();
    EXPECT_TRUE(circuit.isOn(circuit["lamp"]));
    EXPECT_EQ(circuit.circuitOf("lamp").level, ElectricalLevel::singleCable);
}

TEST(ElectricitySufficientLevel, IsPickedForEachCircuitOfAScene) {
    NodalWorld circuit;
    drawCircuit(circuit, " 1");
    drawCircuit(circuit, " 2");
    circuit.store().column<Resistance>().set(circuit["lamp 2"], {6});
    circuit.begin();
    EXPECT_EQ(levelAtWork(circuit), "nodal");
    EXPECT_EQ(circuit.circuitOf("lamp 1").level, ElectricalLevel::twoWire);
    EXPECT_EQ(circuit.circuitOf("lamp 1").reason, ElectricalReason::onOffOnly);
    EXPECT_EQ(circuit.circuitOf("lamp 2").level, ElectricalLevel::nodal);
    EXPECT_EQ(circuit.circuitOf("lamp 2").reason, ElectricalReason::resistance);
    EXPECT_EQ(circuit.circuitOf("lamp 2").because, circuit["lamp 2"]);
    EXPECT_TRUE(circuit.isOn(circuit["lamp 1"]));
    EXPECT_EQ(circuit.at("lamp 1").current, 0); // no resistance is stated
    EXPECT_DOUBLE_EQ(circuit.at("lamp 2").current, unstatedEmf / 6);
    // A wire between the two makes them one circuit, which has a resistance.
    circuit.connect("minus 1", "minus 2");
    EXPECT_EQ(circuit.circuitOf("lamp 1").level, ElectricalLevel::nodal);
    EXPECT_EQ(circuit.quantities().circuits.size(), 1U);
    EXPECT_FALSE(circuit.circuitOf("lamp 1").shorted.empty()); // because its lamp has none
    circuit.disconnect("minus 1", "minus 2");
    EXPECT_EQ(circuit.circuitOf("lamp 1").level, ElectricalLevel::twoWire);
    EXPECT_TRUE(circuit.isOn(circuit["lamp 1"]));
    EXPECT_EQ(circuit.quantities().circuits.size(), 2U);
}

TEST(ElectricitySufficientLevel, FollowsAddedAndRemovedObjects) {
    NodalWorld circuit;
    drawCircuit(circuit, "");
    circuit.resistor("resistor", 3);
    circuit.begin();
    EXPECT_EQ(levelAtWork(circuit), "nodal");
    circuit.call({}, {circuit["resistor"]});
    EXPECT_EQ(levelAtWork(circuit), "two-wire");
    EXPECT_TRUE(circuit.isOn(circuit["lamp"]));
    EXPECT_TRUE(circuit.quantities().byIndex.empty());
}

// An object that is off at a cheaper level is off at all more expensive ones.
TEST(ElectricitySufficientLevel, TheCheaperLevelsErrOnOneSideOnly) {
    for (unsigned seed = 0; seed < 60; ++seed) {
        std::vector<std::vector<std::string>> on;
        for (char const* const level : {"nodal", "two-wire", "single-cable"}) {
            NodalWorld circuit(level);
            unsigned state = seed * 747796405U + 2891336453U;
            auto const below = [&](unsigned bound) {
                state = state * 1664525U + 1013904223U;
                return (state >> 8U) % bound;
            };
            std::vector<std::string> names;
            for (int i = 0; i < 14; ++i) {
                names.push_back("object " + std::to_string(i));
                if (i == 0) {
                    circuit.battery(names.back(), 9, 1);
                } else if (i == 1) {
                    circuit.returning(names.back());
                } else if (below(2) == 0) {
                    circuit.resistor(names.back(), 1 + below(20));
                } else {
                    circuit.conductor(names.back());
                }
            }
            for (int i = 0; i < 20; ++i) {
                std::string const& a = names[below(14)];
                std::string const& b = names[below(14)];
                if (a != b) {
                    circuit.wire({{a, b}});
                }
            }
            circuit.begin();
            on.push_back(circuit.on());
        }
        EXPECT_TRUE(std::includes(on[1].begin(), on[1].end(), on[0].begin(), on[0].end())) << seed;
        EXPECT_TRUE(std::includes(on[2].begin(), on[2].end(), on[1].begin(), on[1].end())) << seed;
    }
}

} // namespace
} // namespace trembler::test
