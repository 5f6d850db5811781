// Netlists of networks: their nodes and branches, which do not depend on the order of the walk.
#include "physics/electricity/core/netlist.hpp"
#include "tests/physics/electricity/wired_objects.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>
#include <set>

namespace trembler::test {
namespace netlist_test {
namespace {

Netlist netlistOf(WiredObjects const& objects, ObjectId seed, std::string_view network = {}) {
    Netlist made;
    makeNetlist(objects.circuitOf(seed), objects.nodal(), network, made);
    return made;
}

TEST(Netlist, ResistancesAreStatedOrFollowFromTheRatingAndStayWithinTheirLimits) {
    WiredObjects objects;
    struct Case {
        double stated;
        double expected;
    };
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double inf = std::numeric_limits<double>::infinity();
    std::uint32_t next = 0;
    for (Case const& c : {Case{5, 5}, Case{0, 0}, Case{-3, 0}, Case{nan, 0}, Case{1e-9, 1e-3},
                          Case{1e20, 1e9}, Case{inf, 1e9}, Case{1e-3, 1e-3}, Case{1e9, 1e9}}) {
        ObjectId const id = objects.conductor(next++);
        objects.resistances.set(id, {c.stated});
        EXPECT_EQ(resistanceOf(objects.nodal(), id), c.expected) << c.stated;
    }
    ObjectId const lamp = objects.conductor(next++);
    EXPECT_EQ(resistanceOf(objects.nodal(), lamp), 0) << "an ideal conductor";
    RatedPower rating;
    rating.voltage = 12;
    rating.power = 6;
    objects.ratings.set(lamp, rating);
    EXPECT_DOUBLE_EQ(resistanceOf(objects.nodal(), lamp), 24) << "P = U²/R";
    rating.power = 0;
    objects.ratings.set(lamp, rating);
    EXPECT_EQ(resistanceOf(objects.nodal(), lamp), greatestResistance);
    objects.resistances.set(lamp, {7});
    EXPECT_EQ(resistanceOf(objects.nodal(), lamp), 7) << "a stated resistance takes precedence";
}

TEST(Netlist, ABranchHoldsHalfOfTheObjectsAtItsEnds) {
    WiredObjects objects;
    ObjectId const minus = objects.conductor(3);
    ObjectId const lamp = objects.conductor(5);
    ObjectId const plus = objects.conductor(8);
    ObjectId const bare = objects.conductor(9);
    objects.resistances.set(minus, {2});
    objects.resistances.set(lamp, {10});
    objects.resistances.set(plus, {4});
    objects.sources.set(plus, {});
    objects.emfs.set(plus, {9, 0.5});
    objects.sources.set(bare, {});
    objects.returns.set(minus, {});
    objects.connect(plus, lamp);
    objects.connect(minus, lamp);
    objects.connect(plus, bare);
    Netlist const made = netlistOf(objects, lamp);
    EXPECT_EQ(made.objects, (std::vector<ObjectId>{minus, lamp, plus, bare}));
    EXPECT_EQ(made.resistances, (std::vector<double>{2, 10, 4, 0}));
    EXPECT_EQ(made.earth(), 4U);
    using Kind = Netlist::Kind;
    std::vector<Netlist::Branch> const expected{
        {0, 1, Kind::connection, 6, 0}, {1, 2, Kind::connection, 7, 0},       {2, 3, Kind::connection, 2, 0},
        {4, 2, Kind::source, 2.5, 9},   {4, 3, Kind::source, 0, unstatedEmf}, {0, 4, Kind::returning, 1, 0}};
    EXPECT_EQ(made.branches, expected);
}

TEST(Netlist, ANonFiniteEmfIsZeroAndALargeOneIsLimited) {
    WiredObjects objects;
    ObjectId const plus = objects.conductor(0);
    objects.sources.set(plus, {});
    struct Case {
        double stated;
        double expected;
    };
    for (Case const& c :
         {Case{-5, -5}, Case{std::nan(""), 0}, Case{HUGE_VAL, 0}, Case{1e300, 1e6}, Case{-1e300, -1e6}}) {
        objects.emfs.set(plus, {c.stated, std::nan("")});
        Netlist const made = netlistOf(objects, plus);
        ASSERT_EQ(made.branches.size(), 1U);
        EXPECT_EQ(made.branches[0].emf, c.expected) << c.stated;
        EXPECT_EQ(made.branches[0].resistance, 0);
    }
}

// The expected nodes and branches, counted from the objects themselves; the netlist is the same for any start
// of the walk.
TEST(Netlist, HasTheNetworksObjectsForAnyStartOfTheWalk) {
    EXPECT_TRUE(rc::check("the same from every seed, and whole", [] {
        auto const below = [](std::uint32_t bound) {
            return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0U, bound));
        };
        WiredObjects objects;
        std::uint32_t const count = 2 + below(9);
        auto const anyNetwork = [&] { return *rc::gen::element<std::string>("", "", "mains"); };
        std::vector<ObjectId> all;
        for (std::uint32_t v = 0; v < count; ++v) {
            ObjectId const id = objects.conductor((v * 7) % 11, below(4) == 0 ? "mains" : "");
            all.push_back(id);
            objects.resistances.set(id, {static_cast<double>(below(5))});
            if (below(3) == 0) {
                objects.sources.set(id, {anyNetwork()});
            }
            if (below(3) == 0) {
                objects.returns.set(id, {anyNetwork()});
            }
        }
        std::set<std::pair<ObjectId, ObjectId>> pairs;
        auto const join = [&](ObjectId a, ObjectId b) {
            if (a != b) {
                objects.connect(a, b);
                pairs.insert(std::minmax(a, b));
            }
        };
        for (std::uint32_t v = 1; v < count; ++v) { // one circuit
            join(all[v], all[below(v)]);
        }
        for (std::uint32_t extra = below(count); extra > 0; --extra) {
            join(all[below(count)], all[below(count)]);
        }
        for (std::string const network : {"", "mains"}) {
            Netlist const made = netlistOf(objects, all.front(), network);
            for (ObjectId const seed : all) {
                Netlist const other = netlistOf(objects, seed, network);
                RC_ASSERT(other.objects == made.objects);
                RC_ASSERT(other.resistances == made.resistances);
                RC_ASSERT(other.branches == made.branches);
            }
            auto const takesPart = [&](ObjectId id) {
                std::string const& own = objects.conductors[id].network;
                return own.empty() || own == network;
            };
            std::vector<ObjectId> nodes = all;
            std::erase_if(nodes, [&](ObjectId id) { return !takesPart(id); });
            std::sort(nodes.begin(), nodes.end());
            RC_ASSERT(made.objects == nodes);
            std::size_t expected = 0;
            for (auto const& [a, b] : pairs) {
                expected += takesPart(a) && takesPart(b) ? 1U : 0U;
            }
            for (ObjectId const id : nodes) {
                ElectricalSource const* const source = objects.sources.find(id);
                ElectricalReturn const* const returning = objects.returns.find(id);
                expected += source != nullptr && source->network == network ? 1U : 0U;
                expected += returning != nullptr && returning->network == network ? 1U : 0U;
            }
            RC_ASSERT(made.branches.size() == expected);
            double const half = 0.5;
            auto const ohm = [&](std::uint32_t node) {
                return node == made.earth() ? 0 : objects.resistances[made.objects[node]].ohm;
            };
            for (Netlist::Branch const& branch : made.branches) {
                RC_ASSERT(branch.resistance == half * ohm(branch.from) + half * ohm(branch.to));
                if (branch.kind == Netlist::Kind::connection) {
                    RC_ASSERT(pairs.contains({made.objects[branch.from], made.objects[branch.to]}));
                }
            }
        }
    }));
}

} // namespace
} // namespace netlist_test
} // namespace trembler::test
