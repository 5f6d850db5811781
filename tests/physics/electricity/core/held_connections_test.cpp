// Compared with a set: for any earlier connections, the differences lead to the new set.
#include "physics/electricity/core/held_connections.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>
#include <tuple>

namespace trembler {
namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

HeldConnections::Held heldOf(Pair const& pair) {
    return {{pair.first, 1}, {pair.second, 1}, {}, {}};
}

RC_GTEST_PROP(HeldConnections, DifferencesLeadFromOneSetToTheNext, ()) {
    HeldConnections held;
    std::set<Pair> oracle;
    auto const index = rc::gen::inRange<std::uint32_t>(1, 5);
    auto const turns = *rc::gen::container<std::vector<std::vector<Pair>>>(
        rc::gen::container<std::vector<Pair>>(rc::gen::pair(index, index)));
    for (std::vector<Pair> const& turn : turns) {
        std::vector<HeldConnections::Held> now;
        for (Pair const& pair : turn) {
            now.push_back(heldOf(pair));
        }
        for (HeldConnections::Difference const& difference : held.replace(now)) {
            Pair const pair{difference.held.a.index, difference.held.b.index};
            if (difference.delta > 0) {
                RC_ASSERT(oracle.insert(pair).second);
            } else {
                RC_ASSERT(oracle.erase(pair) == 1U);
            }
        }
        RC_ASSERT(oracle == std::set<Pair>(turn.begin(), turn.end()));
        RC_ASSERT(held.empty() == oracle.empty());
    }
}

TEST(HeldConnections, NothingHeldAddsNothingToTheHash) {
    StateHash none;
    StateHash with;
    HeldConnections held;
    held.hash(with);
    EXPECT_EQ(with.digest(), none.digest());
    (void)held.replace({heldOf({1, 2})});
    held.hash(with);
    EXPECT_NE(with.digest(), none.digest());
}

} // namespace
} // namespace trembler
