// The counts of each caller in a counted set, compared with a plain map.
#include "runtime/component/caller_counts.hpp"
#include "runtime/property/state_hash.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace trembler {
namespace {

TEST(CallerId, IsOrderedByRegistrationAfterTheLevelAndOutsideCallers) {
    Callers callers;
    CallerId const first = callers.add("Zeta <- Alpha");
    CallerId const outside = callers.addOutside("the player");
    CallerId const second = callers.add("Alpha <- Zeta");
    EXPECT_LT(CallerId(), CallerId::level());
    EXPECT_LT(CallerId::level(), outside);
    EXPECT_LT(outside, first);
    EXPECT_LT(first, second);
    EXPECT_EQ(first.name(), "Zeta <- Alpha");
    EXPECT_EQ(CallerId::level().name(), "level");
    EXPECT_EQ(CallerId().name(), "");
    EXPECT_FALSE(CallerId());
    EXPECT_TRUE(CallerId::level());
    EXPECT_EQ(first, CallerId(first));
    EXPECT_NE(first, second);
}

TEST(CallerCounts, AreSeparateForEachCaller) {
    Callers callers;
    CallerId const sensor = callers.add("Electricity <- Sound");
    CallerId const dynamo = callers.add("Electricity <- Rotation");
    CallerCounts counts;
    counts.add(sensor, 1);
    counts.add(dynamo, -1);
    EXPECT_TRUE(counts.any()) << "the second caller has no count to remove";
    EXPECT_EQ(counts.of(sensor), 1);
    EXPECT_EQ(counts.of(dynamo), 0);
    EXPECT_EQ(counts.names(), "Electricity <- Sound");
    counts.add(CallerId::level(), 2);
    EXPECT_EQ(counts.names(), "level, Electricity <- Sound");
    counts.add(sensor, -1);
    EXPECT_EQ(counts.of(CallerId::level()), 2);
    counts.add(CallerId::level(), -5);
    EXPECT_FALSE(counts.any());
    EXPECT_EQ(counts, CallerCounts());
}

TEST(CallerCounts, AreLimitedToTheirRange) {
    CallerCounts counts;
    constexpr std::int64_t far = std::numeric_limits<std::int64_t>::max();
    counts.add(CallerId::level(), far);
    counts.add(CallerId::level(), far);
    EXPECT_EQ(counts.of(CallerId::level()), std::numeric_limits<std::int32_t>::max());
    counts.add(CallerId::level(), std::numeric_limits<std::int64_t>::min());
    EXPECT_EQ(counts.of(CallerId::level()), 0);
}

TEST(CallerCounts, HashTheNamesOfCallersAndNotTheirIndices) {
    auto const hashOf = [](int before) {
        Callers callers;
        for (int i = 0; i < before; ++i) {
            callers.add("an effect that this program may be built without");
        }
        CallerCounts counts;
        counts.add(callers.add("Electricity <- Dynamics"), 2);
        counts.add(callers.add("Electricity <- Sound"), 1);
        StateHash hash;
        hash.value(counts.entries());
        return hash.digest();
    };
    EXPECT_EQ(hashOf(0), hashOf(3));
}

// Any sequence of calls by several callers, some of which are removed, compared with a brute-force multiset.
TEST(CallerCounts, AreAMultisetForEachCaller) {
    EXPECT_TRUE(rc::check([] {
        Callers callers;
        std::vector<CallerId> known{CallerId::level()};
        for (char const* name : {"a", "b", "c", "d"}) {
            known.push_back(callers.add(name));
        }
        CallerCounts counts;
        std::map<std::size_t, std::int64_t> oracle;
        auto const deeds = *rc::gen::container<std::vector<std::pair<std::uint8_t, std::int8_t>>>(
            rc::gen::arbitrary<std::pair<std::uint8_t, std::int8_t>>());
        for (auto const& deed : deeds) {
            std::size_t const caller = deed.first % known.size();
            std::size_t const staying = 1 + deed.first % 4U;
            int const change = deed.second % 3;
            if (deed.first >= 240) { // all but one of them are removed, and the level never is
                std::vector<CallerId> const present{known[staying]};
                RC_ASSERT(counts.onlyBy(present) ==
                          std::all_of(oracle.begin(), oracle.end(), [&](auto const& o) {
                              return o.second == 0 || o.first == 0 || o.first == staying;
                          }));
                counts.keepOnly(present);
                std::erase_if(oracle, [&](auto const& o) { return o.first != 0 && o.first != staying; });
            } else {
                CallerCounts const before = counts;
                counts.add(known[caller], change);
                std::int64_t& mine = oracle[caller];
                mine = std::max<std::int64_t>(0, mine + change);
                for (std::size_t other = 0; other < known.size(); ++other) {
                    RC_ASSERT((other == caller || counts.of(known[other]) == before.of(known[other])));
                }
            }
            std::int64_t total = 0;
            for (std::size_t i = 0; i < known.size(); ++i) {
                RC_ASSERT(counts.of(known[i]) == oracle[i]);
                total += oracle[i];
            }
            RC_ASSERT(counts.any() == (total > 0));
            auto const entries = counts.entries();
            RC_ASSERT(std::is_sorted(entries.begin(), entries.end(),
                                     [](auto const& x, auto const& y) { return x.caller < y.caller; }));
            CallerCounts copy = counts;
            RC_ASSERT(copy == counts);
            CallerCounts moved = std::move(copy);
            RC_ASSERT(moved == counts);
            copy = moved;
            moved = CallerCounts();
            RC_ASSERT((copy == counts && !moved.any()));
            CallerCounts again; // the same calls in another order
            for (std::size_t i = known.size(); i-- > 0;) {
                again.add(known[i], oracle[i]);
            }
            RC_ASSERT(again == counts);
        }
    }));
}

} // namespace
} // namespace trembler
