// Nodal analysis compared with closed forms.
#include "physics/electricity/analyses/nodal.hpp"
#include "tests/physics/electricity/nodal_kit.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace trembler::test {
namespace {

constexpr double tight = 1e-12;

void near(double found, double expected, std::string const& what) {
    EXPECT_NEAR(found, expected, tight * std::max(1.0, std::abs(expected))) << what;
}

TEST(ElectricityNodal, VoltageDivider) {
    NodalWorld circuit;
    circuit.battery("plus", 9);
    circuit.resistor("upper", 100);
    circuit.resistor("lower", 200);
    circuit.returning("minus");
    circuit.wire({{"plus", "upper", "middle", "lower", "minus"}, {"middle", "dead end"}});
    circuit.begin();
    near(circuit.at("plus").potential, 9, "an ideal source keeps its EMF");
    near(circuit.at("middle").potential, 6, "U R2 / (R1 + R2)");
    near(circuit.at("dead end").potential, 6, "no current, no drop");
    near(circuit.at("upper").potential, 7.5, "half of the resistance lies before its middle");
    near(circuit.at("minus").potential, 0, "the return");
    for (char const* const name : {"plus", "upper", "middle", "lower", "minus"}) {
        near(circuit.at(name).current, 0.03, name);
        EXPECT_TRUE(circuit.isOn(circuit[name])) << name;
    }
    EXPECT_FALSE(circuit.isOn(circuit["dead end"]));
    near(circuit.at("upper").power, 0.09, "I²R");
    near(circuit.at("lower").power, 0.18, "I²R");
    near(circuit.at("plus").supplied, 0.27, "U I");
    EXPECT_NE(circuit.status("Nodal Electricity").activity, Activity::absent);
    EXPECT_EQ(circuit.status("Two-wire Electricity").activity, Activity::absent);
    EXPECT_EQ(circuit.status("Single-cable Electricity").activity, Activity::absent);
}

TEST(ElectricityNodal, InternalResistance) {
    NodalWorld circuit;
    circuit.battery("plus", 9, 1);
    circuit.resistor("load", 8);
    circuit.returning("minus");
    circuit.wire({{"plus", "load", "minus"}});
    circuit.begin();
    near(circuit.at("load").current, 1, "E / (r + R)");
    near(circuit.at("plus").potential, 8, "E - r I");
    near(circuit.at("plus").power, 1, "what the battery heats itself with");
    near(circuit.at("plus").supplied, 9, "E I");
}

TEST(ElectricityNodal, ASourceWithoutStatedEmfGivesTwelveVolts) {
    NodalWorld circuit;
    circuit.source("plus");
    circuit.resistor("load", 6);
    circuit.returning("minus");
    circuit.wire({{"plus", "load", "minus"}});
    circuit.begin();
    near(circuit.at("load").current, 2, "12 V over 6 ohm");
}

/// A Wheatstone bridge with a lamp across it.
void drawBridge(NodalWorld& circuit, double r1, double r2, double r3, double r4) {
    circuit.battery("plus", 10);
    circuit.returning("minus");
    circuit.resistor("r1", r1);
    circuit.resistor("r2", r2);
    circuit.resistor("r3", r3);
    circuit.resistor("r4", r4);
    circuit.lamp("lamp", 5, 1); // 25 ohm
    circuit.wire({{"plus", "r1", "left", "r3", "minus"},
                  {"plus", "r2", "right", "r4", "minus"},
                  {"left", "lamp", "right"}});
}

TEST(ElectricityNodal, ABalancedBridgesLampIsDarkExceptForTwoWire) {
    NodalWorld circuit;
    drawBridge(circuit, 10, 20, 33, 66);
    circuit.begin();
    EXPECT_LT(circuit.at("lamp").current, 1e-15);
    EXPECT_FALSE(circuit.isOn(circuit["lamp"]));
    EXPECT_TRUE(circuit.isOn(circuit["left"]));
    near(circuit.at("left").potential, 10.0 * 33 / 43, "a divider");
    near(circuit.at("right").potential, 10.0 * 33 / 43, "the same");
    // On and off only: the lamp lies on a path that uses no object twice, so it is called on.
    circuit.world().setDetail("electricity", "two-wire");
    circuit.world().step();
    EXPECT_TRUE(circuit.isOn(circuit["lamp"]));
    EXPECT_TRUE(circuit.quantities().byIndex.empty()); // this level computes no currents
    circuit.world().setDetail("electricity", "nodal");
    circuit.world().step();
    EXPECT_FALSE(circuit.isOn(circuit["lamp"]));
    EXPECT_EQ(circuit.state().switchedOff, std::vector{circuit["lamp"]});
}

TEST(ElectricityNodal, AnUnbalancedBridgeAgreesWithThevenin) {
    NodalWorld circuit;
    drawBridge(circuit, 10, 20, 30, 40);
    circuit.begin();
    double const open = 10 * (30.0 / 40 - 40.0 / 60);
    double const inside = 10.0 * 30 / 40 + 20.0 * 40 / 60;
    double const current = open / (inside + 25);
    near(circuit.at("lamp").current, current, "Thévenin's theorem");
    near(circuit.at("lamp").power, 25 * current * current, "I²R");
    near(circuit.at("lamp").brightness, 25 * current * current, "of one watt");
    EXPECT_EQ(circuit.isOn(circuit["lamp"]), 25 * current * current >= 0.01);
}

TEST(ElectricityNodal, ALadderOfEqualResistorsFollowsFibonacciNumbers) {
    constexpr int sections = 30;
    NodalWorld circuit;
    circuit.battery("plus", 1);
    circuit.returning("minus");
    for (int i = 0; i < sections; ++i) {
        std::string const n = std::to_string(i);
        circuit.resistor("along " + n, 1);
        circuit.resistor("across " + n, 1);
        circuit.wire({{i == 0 ? "plus" : "rung " + std::to_string(i - 1), "along " + n, "rung " + n},
                      {"rung " + n, "across " + n, "minus"}});
    }
    circuit.begin();
    std::vector<double> fibonacci{0, 1};
    while (fibonacci.size() < 2 * sections + 3) {
        fibonacci.push_back(fibonacci[fibonacci.size() - 1] + fibonacci[fibonacci.size() - 2]);
    }
    // Seen from the source n sections have F(2n+1) / F(2n) ohm, and each rung's potential follows.
    near(circuit.at("along 0").current, fibonacci[2 * sections] / fibonacci[2 * sections + 1], "in all");
    for (int i = 0; i < sections; ++i) {
        double const expected =
            fibonacci[static_cast<std::size_t>(2 * (sections - i) - 1)] / fibonacci[2 * sections + 1];
        double const found = circuit.at("rung " + std::to_string(i)).potential;
        EXPECT_NEAR(found / expected, 1, tight) << "rung " << i; // down to the last one, 1e-12 V
    }
}

TEST(ElectricityNodal, ABarWithThreeConnectionsIsAStarOfHalves) {
    NodalWorld circuit;
    circuit.battery("plus", 6);
    circuit.returning("minus");
    circuit.resistor("bar", 4);
    circuit.resistor("a", 2);
    circuit.resistor("b", 2);
    circuit.wire({{"plus", "bar"}, {"bar", "a", "minus"}, {"bar", "b", "minus"}});
    circuit.begin();
    near(circuit.at("bar").current, 6 / (2 + (2 + 2) / 2.0), "2 ohm in, twice 2 + 2 ohm out");
    near(circuit.at("a").current, 0.75, "half of it");
    near(circuit.at("bar").power, 1.5 * 1.5 * 2 + 2 * (0.75 * 0.75 * 2), "all three arms");
}

TEST(ElectricityNodal, BrightnessIsPowerOverRatedPower) {
    NodalWorld circuit;
    circuit.battery("plus", 6);
    circuit.returning("minus");
    circuit.lamp("alone", 6, 3);
    circuit.lamp("one of two", 6, 3);
    circuit.lamp("other of two", 6, 3);
    circuit.wire({{"plus", "alone", "minus"}, {"plus", "one of two", "other of two", "minus"}});
    circuit.begin();
    near(circuit.at("alone").brightness, 1, "at its rated voltage");
    near(circuit.at("alone").power, 3, "W");
    near(circuit.at("one of two").brightness, 0.25, "at half of it");
    EXPECT_TRUE(circuit.isOn(circuit["one of two"]));
}

TEST(ElectricityNodal, ElevenLampsInSeriesAreDarkExceptForTwoWire) {
    for (int const lamps : {9, 11}) {
        NodalWorld circuit;
        circuit.battery("plus", 6);
        circuit.returning("minus");
        std::vector<std::string> row{"plus"};
        for (int i = 0; i < lamps; ++i) {
            row.push_back("lamp " + std::to_string(i));
            circuit.lamp(row.back(), 6, 3);
        }
        row.emplace_back("minus");
        circuit.wire({row});
        circuit.begin();
        near(circuit.at("lamp 3").brightness, 1.0 / (lamps * lamps), "of 1/n of the voltage");
        EXPECT_EQ(circuit.isOn(circuit["lamp 3"]), lamps == 9); // 1.2 % or 0.83 %
        EXPECT_TRUE(circuit.isOn(circuit["minus"]));
        circuit.world().setDetail("electricity", "two-wire");
        circuit.world().step();
        EXPECT_TRUE(circuit.isOn(circuit["lamp 3"]));
    }
}

TEST(ElectricityNodal, AShortedLampIsDarkAndTheShortIsReported) {
    NodalWorld circuit({}, 1, true);
    circuit.battery("plus", 6, 0.5);
    circuit.returning("minus");
    circuit.lamp("lamp", 6, 3);
    circuit.wire({{"plus", "lamp", "minus"}, {"plus", "spanner"}});
    circuit.begin();
    EXPECT_TRUE(circuit.isOn(circuit["lamp"]));
    EXPECT_TRUE(circuit.circuitOf("lamp").shorted.empty());
    circuit.connect("spanner", "minus", 1);
    EXPECT_EQ(circuit.circuitOf("lamp").shorted, std::vector{circuit["plus"]});
    EXPECT_FALSE(circuit.isOn(circuit["lamp"]));
    near(circuit.at("spanner").current, 12, "E / r");
    near(circuit.at("lamp").current, 0, "nothing takes the long way");
    auto const events = circuit.events();
    EXPECT_EQ(std::count(events.begin(), events.end(), "short circuit"), 1);
    circuit.disconnect("spanner", "minus", 1);
    EXPECT_TRUE(circuit.isOn(circuit["lamp"]));
    EXPECT_TRUE(circuit.circuitOf("lamp").shorted.empty());
    // Two-wire: every object lies on some path, including the shorted lamp.
    circuit.connect("spanner", "minus", 1);
    circuit.world().setDetail("electricity", "two-wire");
    circuit.world().step();
    EXPECT_TRUE(circuit.isOn(circuit["lamp"]));
}

TEST(ElectricityNodal, AShortedIdealSourceIsLimitedAndReported) {
    NodalWorld circuit;
    circuit.battery("plus", 12);
    circuit.returning("minus");
    circuit.resistor("load", 5);
    circuit.wire({{"plus", "load", "minus"}, {"plus", "minus"}});
    circuit.begin();
    EXPECT_EQ(circuit.circuitOf("plus").shorted, std::vector{circuit["plus"]});
    near(circuit.at("plus").current, 12 / leastResistance, "limited");
    near(circuit.at("load").current, 0, "no voltage is left");
    near(circuit.at("plus").potential, 0, "nor at the source");
    EXPECT_LE(circuit.circuitOf("plus").residual, 1e-9);
}

TEST(ElectricityNodal, IdealSourcesOfDifferentEmfsJoinedAreLimitedAndReported) {
    NodalWorld circuit;
    circuit.battery("a", 12);
    circuit.battery("b", 6);
    circuit.returning("minus");
    circuit.resistor("load", 9);
    circuit.wire({{"a", "b", "load", "minus"}});
    circuit.begin();
    EXPECT_EQ(circuit.circuitOf("a").shorted, (std::vector{circuit["a"], circuit["b"]}));
    near(circuit.at("load").current, 9 / (9 + 0.5 * leastResistance), "9 V between the two");
    EXPECT_NEAR(circuit.at("b").potential, 9, 1e-3);
}

TEST(ElectricityNodal, EqualIdealSourcesShareTheCurrent) {
    NodalWorld circuit;
    circuit.battery("a", 12);
    circuit.battery("b", 12);
    circuit.returning("minus");
    circuit.resistor("load", 6);
    circuit.wire({{"a", "busbar", "load", "minus"}, {"b", "busbar"}});
    circuit.begin();
    EXPECT_TRUE(circuit.circuitOf("a").shorted.empty());
    near(circuit.at("load").current, 2, "in all");
    near(circuit.at("a").current, 1, "half");
    near(circuit.at("b").current, 1, "half");
}

TEST(ElectricityNodal, IdealConductorsShareAsEqualResistancesWould) {
    NodalWorld circuit;
    circuit.battery("plus", 12);
    circuit.returning("minus");
    circuit.resistor("load", 2);
    // Two paths of two connections each, and one of one connection.
    circuit.wire({{"plus", "upper", "end"}, {"plus", "lower", "end"}, {"plus", "end", "load", "minus"}});
    circuit.begin();
    near(circuit.at("load").current, 6, "in all");
    near(circuit.at("upper").current, 1.5, "conductances of 1/2, 1/2 and 1");
    near(circuit.at("lower").current, 1.5, "the same");
}

TEST(ElectricityNodal, FloatingIslandsAreReported) {
    NodalWorld circuit({}, 1, true);
    circuit.battery("plus", 12);
    circuit.returning("minus");
    circuit.resistor("load", 2);
    circuit.wire({{"plus", "load", "minus"}});
    circuit.resistor("lonely", 5);
    circuit.resistor("pair", 5);
    circuit.wire({{"pair", "partner"}});
    circuit.begin();
    EXPECT_FALSE(circuit.circuitOf("load").floating);
    EXPECT_FALSE(circuit.at("load").floating);
    EXPECT_TRUE(circuit.circuitOf("pair").floating);
    EXPECT_TRUE(circuit.at("partner").floating);
    EXPECT_TRUE(circuit.circuitOf("lonely").floating);
    EXPECT_EQ(circuit.at("partner").current, 0);
    auto events = circuit.events();
    EXPECT_EQ(std::count(events.begin(), events.end(), "floating"), 1); // a single object is not an island
    circuit.connect("partner", "load");
    EXPECT_FALSE(circuit.at("pair").floating);
    near(circuit.at("pair").potential, 6, "with the middle of the load");
    circuit.disconnect("partner", "load");
    EXPECT_TRUE(circuit.at("pair").floating);
    events = circuit.events();
    EXPECT_EQ(std::count(events.begin(), events.end(), "floating"), 2);
    ASSERT_EQ(circuit.quantities().circuits.size(), 3U);
}

TEST(ElectricityNodal, NetworksAreSeparate) {
    NodalWorld circuit;
    circuit.battery("plant", 230, 0, "mains");
    circuit.battery("cell", 4.5, 0, "battery");
    circuit.returning("mains return", "mains");
    circuit.returning("battery return", "battery");
    circuit.store().column<Resistance>().set(circuit.conductor("laser", "mains"), {23});
    circuit.store().column<Resistance>().set(circuit.conductor("flashlight", "battery"), {9});
    circuit.wire({{"plant", "laser", "mains return"}, {"cell", "flashlight", "battery return"}});
    circuit.wire({{"plant", "bar", "cell"}}); // one circuit of two networks
    circuit.begin();
    near(circuit.at("laser").current, 10, "mains");
    near(circuit.at("flashlight").current, 0.5, "battery");
    near(circuit.at("laser").potential, 115, "above its own return");
    EXPECT_EQ(circuit.quantities().circuits.size(), 1U);
}

TEST(ElectricityNodal, OnlyWhatChangedIsComputedAgain) {
    NodalWorld circuit;
    for (int i = 0; i < 5; ++i) {
        std::string const n = " " + std::to_string(i);
        circuit.battery("plus" + n, 12);
        circuit.returning("minus" + n);
        circuit.resistor("load" + n, 2);
        circuit.wire({{"plus" + n, "load" + n, "minus" + n}});
    }
    circuit.begin();
    std::uint64_t const updates = circuit.status("Nodal Electricity").updates;
    for (int i = 0; i < 10; ++i) {
        circuit.world().step();
    }
    EXPECT_EQ(circuit.status("Nodal Electricity").updates, updates);
    EXPECT_EQ(circuit.status("Nodal Electricity").activity, Activity::asleep);
    circuit.store().column<Resistance>().set(circuit["load 3"], {4});
    circuit.world().step();
    EXPECT_EQ(circuit.status("Nodal Electricity").updates, updates + 1);
    near(circuit.at("load 3").current, 3, "the new value");
    near(circuit.at("load 2").current, 6, "the old one");
    circuit.store().column<Emf>().set(circuit["plus 2"], {6, 0});
    circuit.world().step();
    near(circuit.at("load 2").current, 3, "half the EMF");
    EXPECT_TRUE(circuit.state().switchedOff.empty());
}

} // namespace
} // namespace trembler::test
