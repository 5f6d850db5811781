// Objects that are connected to a source, against the closure of all connections.
#include "physics/electricity/analyses/single_cable.hpp"
#include "tests/physics/electricity/wired_objects.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace trembler::test {
namespace single_cable_test {
namespace {

/// The indices of the objects that are on in the circuit of an object.
std::set<std::uint32_t> onIn(WiredObjects const& objects, std::uint32_t seed = 0) {
    Circuit const circuit = objects.circuitOf({seed, 0});
    std::vector<std::uint8_t> on(circuit.size(), 0);
    markSingleCable(circuit, on);
    std::set<std::uint32_t> found;
    for (std::uint32_t v = 0; v < circuit.size(); ++v) {
        if (on[v] != 0) {
            found.insert(circuit.objects[v].index);
        }
    }
    return found;
}

/// The objects as a test states them, apart from the columns.
struct Plan {
    struct Part {
        std::string network;
        std::optional<std::string> source;
    };
    std::vector<Part> parts;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> wires;

    /// Warshall's closure of the connections between objects that take part in a network, for each network.
    [[nodiscard]] std::set<std::uint32_t> on() const {
        std::set<std::uint32_t> found;
        std::size_t const count = parts.size();
        for (std::string const network : {"", "mains", "phone"}) {
            auto const takesPart = [&](std::size_t v) {
                return parts[v].network.empty() || parts[v].network == network;
            };
            std::vector<std::vector<bool>> reaches(count, std::vector<bool>(count, false));
            for (std::size_t v = 0; v < count; ++v) {
                reaches[v][v] = takesPart(v);
            }
            for (auto const& [a, b] : wires) {
                if (takesPart(a) && takesPart(b)) {
                    reaches[a][b] = true;
                    reaches[b][a] = true;
                }
            }
            for (std::size_t via = 0; via < count; ++via) {
                for (std::size_t a = 0; a < count; ++a) {
                    for (std::size_t b = 0; b < count; ++b) {
                        reaches[a][b] = reaches[a][b] || (reaches[a][via] && reaches[via][b]);
                    }
                }
            }
            for (std::size_t a = 0; a < count; ++a) {
                for (std::size_t b = 0; b < count; ++b) {
                    if (parts[a].source == network && reaches[a][b]) {
                        found.insert(static_cast<std::uint32_t>(b));
                    }
                }
            }
        }
        return found;
    }
};

TEST(MarkSingleCable, MarksWhatASourceReachesInItsNetwork) {
    EXPECT_TRUE(rc::check("the same as the closure of the connections", [] {
        auto const below = [](std::uint32_t bound) {
            return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0U, bound));
        };
        auto const network = [&] { return *rc::gen::element<std::string>("", "", "mains", "phone"); };
        WiredObjects objects;
        Plan plan;
        std::uint32_t const count = 1 + below(9);
        for (std::uint32_t v = 0; v < count; ++v) {
            Plan::Part part;
            part.network = below(3) == 0 ? network() : "";
            ObjectId const id = objects.conductor(v, part.network);
            if (below(4) == 0) {
                part.source = network();
                objects.sources.set(id, {*part.source});
            }
            if (below(4) == 0) {
                objects.returns.set(id, {network()}); // changes nothing
            }
            plan.parts.push_back(part);
        }
        for (std::uint32_t i = below(2 * count); i > 0; --i) {
            std::uint32_t const a = below(count);
            std::uint32_t const b = below(count);
            if (a != b) {
                objects.connect({a, 0}, {b, 0});
                plan.wires.emplace_back(a, b);
            }
        }
        std::set<std::uint32_t> found;
        for (std::uint32_t seed = 0; seed < count; ++seed) {
            found.merge(onIn(objects, seed));
        }
        RC_ASSERT(found == plan.on());
        RC_CLASSIFY(!found.empty() && found.size() < count, "some are on and some are not");
    }));
}

TEST(MarkSingleCable, OneCableIsEnough) {
    WiredObjects objects;
    for (std::uint32_t v = 0; v < 4; ++v) {
        objects.conductor(v);
    }
    objects.sources.set({0, 0}, {});
    EXPECT_EQ(onIn(objects), (std::set<std::uint32_t>{0})) << "a source alone";
    objects.connect({0, 0}, {1, 0});
    objects.connect({1, 0}, {2, 0});
    EXPECT_EQ(onIn(objects), (std::set<std::uint32_t>{0, 1, 2}));
    EXPECT_TRUE(onIn(objects, 3).empty());
}

TEST(MarkSingleCable, AnObjectOfAnotherNetworkIsNoWayThrough) {
    WiredObjects objects;
    objects.conductor(0U);
    objects.conductor(1U, "phone");
    objects.conductor(2U);
    objects.sources.set({0, 0}, {"mains"});
    objects.connect({0, 0}, {1, 0});
    objects.connect({1, 0}, {2, 0});
    EXPECT_EQ(onIn(objects), (std::set<std::uint32_t>{0}));
    // With a source of the telephone at the other end, the middle is on, and so is every object that it
    // reaches.
    objects.sources.set({2, 0}, {"phone"});
    EXPECT_EQ(onIn(objects), (std::set<std::uint32_t>{0, 1, 2}));
}

TEST(MarkSingleCable, NetworksReachOnlyTheirOwnObjectsThroughSharedConductors) {
    WiredObjects objects;
    for (std::uint32_t v : {0U, 1U, 2U, 7U}) {
        objects.conductor(v); // a shared cable 0-1-2, and 7 elsewhere
    }
    objects.conductor(3U, "a");
    objects.conductor(4U, "b");
    objects.conductor(5U, "a");
    objects.conductor(6U, "c");
    objects.sources.set({3, 0}, {"a"});
    objects.sources.set({4, 0}, {"b"});
    objects.connect({0, 0}, {1, 0});
    objects.connect({1, 0}, {2, 0});
    objects.connect({3, 0}, {0, 0});
    objects.connect({5, 0}, {2, 0});
    objects.connect({5, 0}, {7, 0});
    objects.connect({6, 0}, {2, 0});
    objects.connect({4, 0}, {7, 0});
    EXPECT_EQ(onIn(objects), (std::set<std::uint32_t>{0, 1, 2, 3, 4, 5, 7})) << "not 6, of a third network";
    objects.sources.set({3, 0}, {"c"}); // a device of "a" is no source of "c"
    EXPECT_EQ(onIn(objects), (std::set<std::uint32_t>{4, 7})) << "5 is no way through for \"b\"";
}

TEST(MarkSingleCable, AHundredThousandObjectsInARowNeedNoRecursion) {
    WiredObjects objects;
    constexpr std::uint32_t count = 100'000;
    for (std::uint32_t v = 0; v < count; ++v) {
        objects.conductor(v);
        if (v > 0) {
            objects.connect({v - 1, 0}, {v, 0});
        }
    }
    objects.sources.set({count / 2, 0}, {});
    EXPECT_EQ(onIn(objects).size(), count);
}

} // namespace
} // namespace single_cable_test
} // namespace trembler::test
