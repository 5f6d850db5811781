// The vertices of a circuit by network, compared with asking every vertex; and netlists made with and without
// them.
#include "physics/electricity/core/netlist.hpp"
#include "physics/electricity/core/network_members.hpp"
#include "tests/physics/electricity/wired_objects.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>

namespace trembler::test {
namespace network_members_test {
namespace {

using Vertices = std::vector<std::uint32_t>;

Vertices both(std::span<std::uint32_t const> a, std::span<std::uint32_t const> b) {
    Vertices all(a.begin(), a.end());
    all.insert(all.end(), b.begin(), b.end());
    std::sort(all.begin(), all.end());
    return all;
}

TEST(NetworkMembers, AreThoseThatTakePart) {
    EXPECT_TRUE(rc::check("as asked of every vertex", [] {
        auto const below = [](std::uint32_t bound) {
            return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0U, bound));
        };
        std::vector<std::string> const names{"", "", "a", "b", "c"};
        WiredObjects objects;
        std::uint32_t const count = 1 + below(12);
        for (std::uint32_t v = 0; v < count; ++v) {
            ObjectId const id = objects.conductor(v, names[below(5)]);
            objects.resistances.set(id, {static_cast<double>(1 + below(9))});
            if (below(2) == 0) {
                objects.sources.set(id, {names[below(5)]});
            }
            if (below(2) == 0) {
                objects.returns.set(id, {names[below(5)]});
            }
        }
        for (std::uint32_t i = below(3 * count); i > 0; --i) {
            if (ObjectId const a{below(count), 0}, b{below(count), 0}; a != b) {
                objects.connect(a, b);
            }
        }
        Circuit const circuit = objects.circuitOf({below(count), 0});
        NetworkMembers const members(circuit);
        for (std::string const network : {"", "a", "b", "c", "none of them"}) {
            Vertices expected;
            for (std::uint32_t v = 0; v < circuit.size(); ++v) {
                if (circuit.takesPart(v, network)) {
                    expected.push_back(v);
                }
            }
            RC_ASSERT(both(members.plain(), members.own(network)) == expected);
            for (std::uint32_t v = 0; v < circuit.size(); ++v) {
                Vertices neighbours;
                for (std::uint32_t const w : circuit.neighboursOf(v)) {
                    if (circuit.takesPart(w, network)) {
                        neighbours.push_back(w);
                    }
                }
                std::sort(neighbours.begin(), neighbours.end());
                RC_ASSERT(both(members.plainNeighboursOf(v), members.ownNeighboursOf(v, network)) ==
                          neighbours);
            }
            Vertices sources;
            for (Circuit::Terminal const& terminal : circuit.sources) {
                if (terminal.network == network) {
                    sources.push_back(terminal.vertex);
                }
            }
            Vertices found;
            for (Circuit::Terminal const& terminal : terminalsOf(circuit.sources, network)) {
                found.push_back(terminal.vertex);
            }
            RC_ASSERT(found == sources);
            Netlist with;
            Netlist without;
            makeNetlist(circuit, objects.nodal(), network, with, &members);
            makeNetlist(circuit, objects.nodal(), network, without);
            RC_ASSERT(with.objects == without.objects);
            RC_ASSERT(with.vertex == without.vertex);
            RC_ASSERT(with.resistances == without.resistances);
            RC_ASSERT(with.branches == without.branches);
        }
    }));
}

} // namespace
} // namespace network_members_test
} // namespace trembler::test
