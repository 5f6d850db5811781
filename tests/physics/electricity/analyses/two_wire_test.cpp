// Objects on a path from source to return, compared with a search over all paths.
#include "physics/electricity/analyses/two_wire.hpp"
#include "tests/physics/electricity/wired_objects.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace trembler::test {
namespace two_wire_test {
namespace {

/// Follows every path that uses no object twice, and marks the objects of paths that end at a return.
class EveryWay {
public:
    EveryWay(Circuit const& circuit, std::string_view network) : circuit_(circuit), network_(network) {
        onWay_.assign(circuit.size(), false);
        marked.assign(circuit.size(), false);
        for (Circuit::Terminal const& source : circuit.sources) {
            if (source.network == network) {
                go(source.vertex);
            }
        }
    }
    std::vector<bool> marked;

private:
    void go(std::uint32_t v) {
        if (onWay_[v] || !circuit_.takesPart(v, network_)) {
            return;
        }
        onWay_[v] = true;
        for (Circuit::Terminal const& end : circuit_.returns) {
            if (end.network == network_ && end.vertex == v) {
                for (std::uint32_t w = 0; w < circuit_.size(); ++w) {
                    marked[w] = marked[w] || onWay_[w];
                }
            }
        }
        for (std::uint32_t const w : circuit_.neighboursOf(v)) {
            go(w);
        }
        onWay_[v] = false;
    }

    Circuit const& circuit_;
    std::string_view network_;
    std::vector<bool> onWay_;
};

TEST(MarkTwoWire, MarksTheObjectsOnPathsFromSourceToReturn) {
    EXPECT_TRUE(rc::check("the same as trying every way", [] {
        auto const below = [](std::uint32_t bound) {
            return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0U, bound));
        };
        auto const network = [&] { return *rc::gen::element<std::string>("", "", "", "mains"); };
        WiredObjects objects;
        std::uint32_t const count = 1 + below(8);
        for (std::uint32_t v = 0; v < count; ++v) {
            ObjectId const id = objects.conductor(v, below(5) == 0 ? "mains" : "");
            if (below(4) == 0) {
                objects.sources.set(id, {network()});
            }
            if (below(4) == 0) {
                objects.returns.set(id, {network()});
            }
        }
        for (std::uint32_t i = below(2 * count); i > 0; --i) {
            ObjectId const a{below(count), 0};
            ObjectId const b{below(count), 0};
            if (a != b) {
                objects.connect(a, b);
            }
        }
        bool any = false;
        for (std::uint32_t seed = 0; seed < count; ++seed) {
            Circuit const circuit = objects.circuitOf({seed, 0});
            EveryWay const common(circuit, "");
            EveryWay const mains(circuit, "mains");
            std::vector<std::uint8_t> on(circuit.size(), 0);
            markTwoWire(circuit, on);
            for (std::uint32_t v = 0; v < circuit.size(); ++v) {
                RC_ASSERT((on[v] != 0) == (common.marked[v] || mains.marked[v]));
                any = any || on[v] != 0;
            }
        }
        RC_CLASSIFY(any, "something is on");
    }));
}

// Networks that share plain conductors: many of these, so that their blocks and dead ends have all forms.
TEST(MarkTwoWire, MarksThePathsOfAllNetworksThatShareConductors) {
    EXPECT_TRUE(rc::check("the same as trying every way in each network", [] {
        auto const below = [](std::uint32_t bound) {
            return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0U, bound));
        };
        std::vector<std::string> const names{"a", "b", "c", ""};
        WiredObjects objects;
        std::uint32_t const count = 3 + below(8);
        std::uint32_t const plainShare = 1 + below(4); // of 5
        for (std::uint32_t v = 0; v < count; ++v) {
            bool const plain = below(5) < plainShare;
            ObjectId const id = objects.conductor(v, plain ? "" : names[below(3)]);
            if (below(3) == 0) {
                objects.sources.set(id, {names[below(4)]});
            }
            if (below(3) == 0) {
                objects.returns.set(id, {names[below(4)]});
            }
        }
        for (std::uint32_t i = below(2 * count); i > 0; --i) {
            ObjectId const a{below(count), 0};
            ObjectId const b{below(count), 0};
            if (a != b) {
                objects.connect(a, b);
            }
        }
        std::size_t networksOn = 0;
        for (std::uint32_t seed = 0; seed < count; ++seed) {
            Circuit const circuit = objects.circuitOf({seed, 0});
            std::vector<bool> expected(circuit.size(), false);
            std::size_t withCurrent = 0;
            for (std::string const& name : names) {
                EveryWay const ways(circuit, name);
                withCurrent += std::find(ways.marked.begin(), ways.marked.end(), true) != ways.marked.end();
                for (std::uint32_t v = 0; v < circuit.size(); ++v) {
                    expected[v] = expected[v] || ways.marked[v];
                }
            }
            networksOn = std::max(networksOn, withCurrent);
            std::vector<std::uint8_t> on(circuit.size(), 0);
            markTwoWire(circuit, on);
            for (std::uint32_t v = 0; v < circuit.size(); ++v) {
                RC_ASSERT((on[v] != 0) == expected[v]);
            }
        }
        RC_CLASSIFY(networksOn > 1, "several networks have current in one circuit");
    }));
}

/// The numbers of the objects that are on, in a circuit of objects numbered from 0.
std::set<std::uint32_t> onIn(WiredObjects const& objects) {
    Circuit const circuit = objects.circuitOf({0, 0});
    std::vector<std::uint8_t> on(circuit.size(), 0);
    markTwoWire(circuit, on);
    std::set<std::uint32_t> found;
    for (std::uint32_t v = 0; v < circuit.size(); ++v) {
        if (on[v] != 0) {
            found.insert(circuit.objects[v].index);
        }
    }
    return found;
}

TEST(MarkTwoWire, ABatteryIsOnOnlyWhileSomethingClosesItsCircuit) {
    WiredObjects objects;
    for (std::uint32_t v = 0; v < 4; ++v) {
        objects.conductor(v);
    }
    objects.sources.set({0, 0}, {});
    objects.returns.set({3, 0}, {});
    objects.connect({0, 0}, {1, 0});
    objects.connect({2, 0}, {3, 0});
    EXPECT_TRUE(onIn(objects).empty());
    objects.connect({1, 0}, {2, 0});
    EXPECT_EQ(onIn(objects), (std::set<std::uint32_t>{0, 1, 2, 3}));
    // An object that is both source and return needs no other object.
    objects.returns.set({0, 0}, {});
    EXPECT_TRUE(onIn(objects).contains(0));
}

TEST(MarkTwoWire, AHundredThousandObjectsInARowDoNotOverflowTheStack) {
    WiredObjects objects;
    constexpr std::uint32_t count = 100'000;
    for (std::uint32_t v = 0; v < count; ++v) {
        objects.conductor(v);
        if (v > 0) {
            objects.connect({v - 1, 0}, {v, 0});
        }
    }
    objects.sources.set({0, 0}, {});
    objects.returns.set({count - 2, 0}, {});
    EXPECT_EQ(onIn(objects).size(), count - 1) << "all except the dead end";
}

} // namespace
} // namespace two_wire_test
} // namespace trembler::test
