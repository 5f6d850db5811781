// Fuses: when they blow, which of several blows, and that they stay blown.
#include "tests/physics/electricity/nodal_kit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

namespace trembler::test {
namespace {

bool blown(NodalWorld& circuit, std::string const& name) {
    return circuit.store().column<Fuse>()[circuit[name]].blown;
}

/// plus - fuse - bar - load - minus, and a second load that can be connected to the bar; 6 A each.
void draw(NodalWorld& circuit, double rating) {
    circuit.battery("plus", 12);
    circuit.returning("minus");
    circuit.fuse("fuse", rating);
    circuit.resistor("load", 2);
    circuit.resistor("second", 2);
    circuit.wire({{"plus", "fuse", "bar", "load", "minus"}, {"second", "minus"}});
    circuit.begin();
}

TEST(ElectricityFuses, BlowAboveTheirRatingAndStayBlown) {
    NodalWorld circuit({}, 1, true);
    draw(circuit, 10);
    circuit.call({});
    EXPECT_FALSE(blown(circuit, "fuse"));
    EXPECT_DOUBLE_EQ(circuit.at("fuse").overload, 0.6);
    circuit.connect("bar", "second");
    EXPECT_DOUBLE_EQ(circuit.at("fuse").current, 12);
    EXPECT_FALSE(blown(circuit, "fuse")); // the effect of the current follows in the next frame
    circuit.world().step();
    EXPECT_TRUE(blown(circuit, "fuse"));
    EXPECT_TRUE(circuit.store().column<ElectricityGraph>()[circuit["fuse"]].connections.empty());
    EXPECT_FALSE(circuit.isOn(circuit["load"]));
    EXPECT_EQ(circuit.at("load").current, 0);
    EXPECT_TRUE(circuit.at("fuse").floating);
    // Neither removing the load, nor a contact, nor another detail level repairs it.
    circuit.disconnect("bar", "second");
    circuit.connect("fuse", "bar", 1);
    circuit.connect("fuse", "plus", 0);
    EXPECT_TRUE(circuit.store().column<ElectricityGraph>()[circuit["fuse"]].connections.empty());
    for (char const* const level : {"two-wire", "nodal", "single-cable"}) {
        circuit.world().setDetail("electricity", level);
        circuit.call({});
        EXPECT_FALSE(circuit.isOn(circuit["load"])) << level;
    }
    EXPECT_TRUE(blown(circuit, "fuse"));
}

TEST(ElectricityFuses, TheTraceNamesTheCause) {
    NodalWorld circuit({}, 1, true);
    draw(circuit, 10);
    circuit.connect("bar", "second");
    circuit.world().step();
    Tracer const& tracer = *circuit.world().tracer();
    auto const off = std::find_if(tracer.events().begin(), tracer.events().end(), [](Event const& event) {
        return event.event == "off" && event.objects == std::vector<std::string>{"load"};
    });
    ASSERT_NE(off, tracer.events().end());
    std::vector<std::string> chain;
    for (EventId const id : tracer.chain(off->id)) {
        chain.push_back(tracer.find(id)->event);
    }
    for (char const* const step : {"connected", "overloaded", "blowFuse", "blown", "disconnected", "off"}) {
        EXPECT_EQ(std::count(chain.begin(), chain.end(), step) > 0, true) << step;
    }
}

TEST(ElectricityFuses, DoNotBlowAtTheirRating) {
    NodalWorld circuit;
    draw(circuit, 6);
    circuit.call({});
    circuit.call({});
    EXPECT_FALSE(blown(circuit, "fuse"));
    NodalWorld other;
    draw(other, 5.999999);
    other.call({});
    EXPECT_TRUE(blown(other, "fuse"));
}

TEST(ElectricityFuses, TheWeakestInSeriesBlowsAndProtectsTheOthers) {
    NodalWorld circuit;
    circuit.battery("plus", 12, 0.1);
    circuit.returning("minus");
    circuit.fuse("strong", 10);
    circuit.fuse("weak", 2);
    circuit.fuse("middling", 5);
    circuit.wire({{"plus", "strong", "weak", "middling", "minus"}});
    circuit.begin();
    circuit.call({});
    circuit.call({});
    EXPECT_TRUE(blown(circuit, "weak"));
    EXPECT_FALSE(blown(circuit, "strong"));
    EXPECT_FALSE(blown(circuit, "middling"));
}

TEST(ElectricityFuses, EqualOnesInParallelBlowTogetherAndUnequalOnesInTurn) {
    for (double const second : {4.0, 5.0}) {
        NodalWorld circuit;
        circuit.battery("plus", 12);
        circuit.returning("minus");
        circuit.fuse("a", 4);
        circuit.fuse("b", second);
        circuit.resistor("load", 1);
        circuit.wire({{"plus", "a", "bar", "load", "minus"}, {"plus", "b", "bar"}}); // 6 A each
        circuit.begin();
        circuit.world().step();
        EXPECT_TRUE(blown(circuit, "a"));
        EXPECT_EQ(blown(circuit, "b"), second == 4.0);
        circuit.world().step();
        EXPECT_TRUE(blown(circuit, "b")); // then it carries 12 A
    }
}

TEST(ElectricityFuses, TwoThatBlowTogetherDisconnectOnce) {
    NodalWorld circuit({}, 1, true);
    circuit.battery("plus", 12);
    circuit.returning("minus");
    circuit.fuse("a", 4);
    circuit.fuse("b", 4);
    circuit.resistor("load", 1);
    circuit.wire({{"plus", "a", "bar", "load", "minus"}, {"plus", "b", "bar"}, {"a", "b"}}); // 6 A each
    circuit.begin();
    circuit.world().step();
    ASSERT_TRUE(blown(circuit, "a") && blown(circuit, "b"));
    for (auto const& [one, neighbour] :
         {std::pair("a", "plus"), {"a", "b"}, {"a", "bar"}, {"b", "plus"}, {"b", "bar"}}) {
        EXPECT_FALSE(connectionBetween(circuit.store(), circuit[one], circuit[neighbour]).any());
        EXPECT_FALSE(connectionBetween(circuit.store(), circuit[neighbour], circuit[one]).any());
        std::set<std::string> const pair{one, neighbour};
        auto const& events = circuit.world().tracer()->events();
        EXPECT_EQ(std::count_if(events.begin(), events.end(),
                                [&](Event const& event) {
                                    return event.event == "disconnected" &&
                                           std::set(event.objects.begin(), event.objects.end()) == pair;
                                }),
                  1)
            << one << " " << neighbour;
    }
    EXPECT_TRUE(connectionBetween(circuit.store(), circuit["bar"], circuit["load"]).any());
    EXPECT_TRUE(connectionBetween(circuit.store(), circuit["load"], circuit["minus"]).any());
}

TEST(ElectricityFuses, OneThatIsBlownFromTheStartConductsNothing) {
    NodalWorld circuit;
    circuit.battery("plus", 12);
    circuit.returning("minus");
    circuit.fuse("fuse", 10);
    circuit.store().column<Fuse>()[circuit["fuse"]].blown = true;
    circuit.resistor("load", 2);
    circuit.wire({{"plus", "fuse", "load", "minus"}});
    circuit.begin();
    EXPECT_FALSE(circuit.isOn(circuit["load"]));
    EXPECT_EQ(circuit.at("load").current, 0);
}

TEST(ElectricityFuses, BlowInTheSameFrameForAnyNumberOfThreads) {
    auto const run = [](int threads) {
        NodalWorld circuit({}, threads);
        // Each branch has a fuse, and no two are equally overloaded.
        circuit.battery("plus", 12, 0.01);
        circuit.returning("minus");
        for (int i = 0; i < 40; ++i) {
            std::string const n = std::to_string(i);
            circuit.fuse("fuse " + n, 1.0 + 0.05 * i);
            circuit.resistor("load " + n, 5.0 + 0.1 * ((i * 7) % 13));
            circuit.wire({{"plus", "fuse " + n, "load " + n, "minus"}});
        }
        circuit.start();
        std::vector<std::uint64_t> hashes;
        for (int frame = 0; frame < 60; ++frame) {
            circuit.world().step();
            hashes.push_back(circuit.world().stateHash());
        }
        return hashes;
    };
    auto const hashes = run(1);
    EXPECT_GT(std::set(hashes.begin(), hashes.end()).size(), 10U); // they blow one by one
    EXPECT_EQ(run(2), hashes);
    EXPECT_EQ(run(3), hashes);
}

} // namespace
} // namespace trembler::test
