// Flows and bottlenecks, compared with minimum cuts found by trying every set of objects.
#include "physics/electricity/analyses/max_flow.hpp"
#include "tests/physics/electricity/nodal_kit.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

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
    // A second way moves the bottleneck.
    circuit.connect("plus", "bar");
    EXPECT_TRUE(std::isinf(circuit.circuitOf("plus").flow));
    EXPECT_TRUE(circuit.circuitOf("plus").bottleneck.empty());
    limited(circuit, "plus", 7);
    circuit.world().step();
    EXPECT_DOUBLE_EQ(circuit.circuitOf("plus").flow, 7);
    EXPECT_EQ(bottleneck(circuit, "plus"), Names{"plus"});
}

TEST(ElectricityFlow, WhatCarriesNothingBreaksTheCircuit) {
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
    EXPECT_TRUE(circuit.isOn(circuit["lamp"])); // which is what this level cannot tell
    circuit.world().setDetail("electricity", "nodal");
    circuit.world().step();
    EXPECT_FALSE(circuit.isOn(circuit["lamp"]));
}

/// A random circuit of at most 9 objects, and the answers by brute force.
struct Sample {
    Circuit circuit;
    std::vector<Microamperes> capacities;

    [[nodiscard]] std::uint32_t subsets() const { return 1U << circuit.size(); }
    /// The objects that current reaches from the sources, those in `removed` left out.
    [[nodiscard]] std::uint32_t reachable(std::uint32_t removed) const {
        std::uint32_t reached = 0;
        for (auto const& source : circuit.sources) {
            reached |= (1U << source.vertex) & ~removed;
        }
        for (std::uint32_t before = ~reached; before != reached;) {
            before = reached;
            for (std::uint32_t v = 0; v < circuit.size(); ++v) {
                for (std::uint32_t const w : circuit.neighboursOf(v)) {
                    reached |= ((reached >> v) & 1U) << w & ~removed;
                }
            }
        }
        return reached;
    }
    [[nodiscard]] bool separates(std::uint32_t removed) const {
        std::uint32_t const reached = reachable(removed);
        return std::none_of(circuit.returns.begin(), circuit.returns.end(),
                            [&](auto const& t) { return ((reached >> t.vertex) & 1U) != 0; });
    }
    [[nodiscard]] Microamperes capacity(std::uint32_t set) const {
        Microamperes sum = 0;
        for (std::uint32_t v = 0; v < circuit.size(); ++v) {
            sum += ((set >> v) & 1U) != 0 ? capacities[v] : 0;
        }
        return std::min(sum, unlimited);
    }
};

int below(int bound) {
    return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, bound));
}

Sample randomSample() {
    Sample sample;
    auto const count = static_cast<std::uint32_t>(2 + below(8));
    std::vector<std::vector<std::uint32_t>> neighbours(count);
    for (int i = below(3 * static_cast<int>(count)); i > 0; --i) {
        auto const a = static_cast<std::uint32_t>(below(static_cast<int>(count)));
        auto const b = static_cast<std::uint32_t>(below(static_cast<int>(count)));
        if (a != b && std::find(neighbours[a].begin(), neighbours[a].end(), b) == neighbours[a].end()) {
            neighbours[a].push_back(b);
            neighbours[b].push_back(a);
        }
    }
    sample.circuit.offsets.push_back(0);
    for (std::uint32_t v = 0; v < count; ++v) {
        sample.circuit.objects.push_back({(v * 7) % 11, 0}); // ids in another order than vertices
        sample.circuit.networks.emplace_back();
        sample.circuit.neighbours.insert(sample.circuit.neighbours.end(), neighbours[v].begin(),
                                         neighbours[v].end());
        sample.circuit.offsets.push_back(static_cast<std::uint32_t>(sample.circuit.neighbours.size()));
        sample.capacities.push_back(below(4) == 0 ? unlimited : below(6));
        if (below(4) == 0) {
            sample.circuit.sources.push_back({"", v});
        }
        if (below(4) == 0) {
            sample.circuit.returns.push_back({"", v});
        }
    }
    return sample;
}

TEST(ElectricityFlow, IsTheMinimumCutOverAllSetsOfObjects) {
    EXPECT_TRUE(rc::check("maximum flow is minimum cut", [] {
        Sample const sample = randomSample();
        MaxFlow const found = maxFlow(sample.circuit, "", sample.capacities);
        Microamperes least = unlimited;
        for (std::uint32_t set = 0; set < sample.subsets(); ++set) {
            if (sample.separates(set)) {
                least = std::min(least, sample.capacity(set));
            }
        }
        RC_ASSERT(found.total == least);
        RC_CLASSIFY(least > 0 && least < unlimited, "limited");
        if (least >= unlimited) {
            RC_ASSERT(found.bottleneck.empty());
            return;
        }
        // The bottleneck is a cut of that capacity, every object of it carries all it can, and nothing
        // carries more than it can.
        std::uint32_t cut = 0;
        for (std::uint32_t const v : found.bottleneck) {
            cut |= 1U << v;
            RC_ASSERT(found.through[v] == sample.capacities[v]);
            RC_ASSERT(found.through[v] > 0);
        }
        for (std::uint32_t v = 0; v < sample.circuit.size(); ++v) {
            RC_ASSERT(found.through[v] >= 0);
            RC_ASSERT(found.through[v] <= sample.capacities[v]);
        }
        std::uint32_t barred = 0; // what carries nothing belongs to no bottleneck, but lets nothing through
        for (std::uint32_t v = 0; v < sample.circuit.size(); ++v) {
            barred |= sample.capacities[v] == 0 ? 1U << v : 0;
        }
        RC_ASSERT(sample.capacity(cut) == least);
        RC_ASSERT(sample.separates(cut | barred));
        // And of all minimum cuts it leaves the least on the source's side.
        std::uint32_t const side = sample.reachable(cut | barred);
        for (std::uint32_t set = 0; set < sample.subsets(); ++set) {
            if (sample.separates(set | barred) && sample.capacity(set) == least) {
                RC_ASSERT((side & ~(sample.reachable(set | barred) | set)) == 0U);
            }
        }
    }));
}

} // namespace
} // namespace flow_test
} // namespace trembler::test
