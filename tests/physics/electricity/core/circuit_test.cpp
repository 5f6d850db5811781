// Circuits found by a walk, compared with components found by disjoint sets.
#include "physics/electricity/core/circuit.hpp"
#include "tests/physics/electricity/wired_objects.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>
#include <numeric>
#include <set>

namespace trembler::test {
namespace circuit_test {
namespace {

std::uint32_t below(std::uint32_t bound) {
    return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0U, bound));
}

TEST(CircuitWalk, FindsEveryComponentOnceWithEveryConnectionInIt) {
    EXPECT_TRUE(rc::check("the same as by joining sets", [] {
        WiredObjects objects;
        std::uint32_t const count = 1 + below(12);
        std::vector<std::uint32_t> leader(count);
        std::iota(leader.begin(), leader.end(), 0U);
        auto const root = [&](std::uint32_t v) {
            while (leader[v] != v) {
                v = leader[v];
            }
            return v;
        };
        for (std::uint32_t v = 0; v < count; ++v) {
            objects.conductor(v);
        }
        std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
        for (std::uint32_t i = below(2 * count); i > 0; --i) {
            std::uint32_t const a = below(count);
            std::uint32_t const b = below(count);
            if (a != b) {
                objects.connect({a, 0}, {b, 0});
                pairs.insert(std::minmax(a, b));
                leader[root(a)] = root(b);
            }
        }
        CircuitWalk walk;
        Circuit circuit;
        for (int round = 0; round < 2; ++round) { // data of the first round must not influence the second
            walk.begin(objects.columns());
            std::map<std::uint32_t, std::uint32_t> number; // of the circuit with that root
            std::set<std::uint32_t> seen;
            for (std::uint32_t i = 0; i < count; ++i) {
                std::uint32_t const seed = (i * 5 + below(count)) % count;
                bool const isNew = !number.contains(root(seed));
                RC_ASSERT((walk.circuitOf({seed, 0}) == CircuitWalk::none) == isNew);
                RC_ASSERT(walk.walk(objects.columns(), {seed, 0}, circuit) == isNew);
                if (!isNew) {
                    continue;
                }
                auto const next = static_cast<std::uint32_t>(number.size());
                number[root(seed)] = next;
                std::set<std::pair<std::uint32_t, std::uint32_t>> found;
                for (std::uint32_t v = 0; v < circuit.size(); ++v) {
                    std::uint32_t const object = circuit.objects[v].index;
                    RC_ASSERT(root(object) == root(seed));
                    RC_ASSERT(seen.insert(object).second);
                    RC_ASSERT(walk.circuitOf({object, 0}) == next);
                    for (std::uint32_t const w : circuit.neighboursOf(v)) {
                        RC_ASSERT(found.insert({object, circuit.objects[w].index}).second);
                    }
                }
                std::size_t expected = 0;
                for (auto const& [a, b] : pairs) {
                    if (root(a) == root(seed)) {
                        RC_ASSERT(found.contains({a, b}) && found.contains({b, a}));
                        expected += 2;
                    }
                }
                RC_ASSERT(found.size() == expected);
            }
        }
    }));
}

TEST(CircuitWalk, AnObjectOfOneNetworkIsNoTerminalOfAnother) {
    WiredObjects objects;
    ObjectId const both = objects.conductor(2);
    ObjectId const battery = objects.conductor(0, "battery");
    ObjectId const wrong = objects.conductor(1, "battery");
    objects.sources.set(both, {"mains"});
    objects.returns.set(both, {"battery"});
    objects.sources.set(battery, {"battery"});
    objects.sources.set(wrong, {"mains"});
    objects.connect(both, battery);
    objects.connect(both, wrong);
    for (ObjectId const seed : {both, battery, wrong}) {
        Circuit const circuit = objects.circuitOf(seed);
        ASSERT_EQ(circuit.size(), 3U);
        EXPECT_EQ(circuit.objects[0], seed) << "the walk begins there";
        ASSERT_EQ(circuit.sources.size(), 2U);
        EXPECT_EQ(circuit.sources[0].network, "battery");
        EXPECT_EQ(circuit.objects[circuit.sources[0].vertex], battery);
        EXPECT_EQ(circuit.sources[1].network, "mains");
        EXPECT_EQ(circuit.objects[circuit.sources[1].vertex], both);
        ASSERT_EQ(circuit.returns.size(), 1U);
        EXPECT_EQ(circuit.objects[circuit.returns[0].vertex], both);
        EXPECT_EQ(circuit.terminalNetworks(), (std::vector<std::string_view>{"battery", "mains"}));
        for (std::uint32_t v = 0; v < 3; ++v) {
            bool const plain = circuit.objects[v] == both;
            EXPECT_TRUE(circuit.takesPart(v, "battery"));
            EXPECT_EQ(circuit.takesPart(v, "mains"), plain);
        }
    }
}

TEST(CircuitWalk, LeavesOutRemovedObjectsAndObjectsThatAreNoVertices) {
    WiredObjects objects;
    ObjectId const a = objects.conductor(0);
    ObjectId const b = objects.conductor(1);
    ObjectId const c = objects.conductor(2);
    objects.connect(a, b);
    objects.connect(b, c);
    objects.graph.remove(b); // a and c still refer to it, as the resolver has not run yet
    EXPECT_EQ(objects.circuitOf(a).size(), 1U);
    EXPECT_TRUE(objects.circuitOf(a).neighbours.empty());
    CircuitWalk walk;
    Circuit circuit;
    walk.begin(objects.columns());
    EXPECT_FALSE(walk.walk(objects.columns(), b, circuit));
    EXPECT_FALSE(walk.walk(objects.columns(), {77, 0}, circuit));
    EXPECT_EQ(walk.circuitOf({77, 0}), CircuitWalk::none);
    EXPECT_TRUE(walk.walk(objects.columns(), c, circuit));
    EXPECT_EQ(walk.circuitOf(c), 0U);
    EXPECT_EQ(walk.circuitOf(a), CircuitWalk::none) << "not yet";
}

} // namespace
} // namespace circuit_test
} // namespace trembler::test
