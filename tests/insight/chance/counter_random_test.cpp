#include "insight/chance/counter_random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace trembler::insight {
namespace {

TEST(CounterRandom, IsSplitMix64) {
    // The first numbers of the generator's published implementation for this seed.
    CounterRandom random(1234567);
    for (std::uint64_t const expected :
         {6457827717110365317ULL, 3203168211198807973ULL, 9817491932198370423ULL, 4593380528125082431ULL,
          16408922859458223821ULL}) {
        EXPECT_EQ(random.next(), expected);
    }
}

TEST(CounterRandom, SpreadsEvenly) {
    CounterRandom random(keyOf(1, {"even"}));
    std::array<int, 10> counts{};
    double bell = 0;
    for (int n = 0; n < 10'000; ++n) {
        double const number = random.unit();
        ASSERT_GE(number, 0);
        ASSERT_LT(number, 1);
        ++counts[static_cast<std::size_t>(10 * number)];
        bell += random.bell();
    }
    double chiSquare = 0;
    for (int const count : counts) {
        chiSquare += (count - 1000.0) * (count - 1000.0) / 1000;
    }
    EXPECT_LT(chiSquare, 27.9) << "the 99.9 % point of chi square with 9 degrees of freedom";
    EXPECT_NEAR(bell / 10'000, 0, 0.02);
}

TEST(CounterRandom, HasAKeyForEachPurpose) {
    std::set<std::uint64_t> const keys{keyOf(1, {"a", "b"}),    keyOf(2, {"a", "b"}),
                                       keyOf(1, {"ab"}),        keyOf(1, {"b", "a"}),
                                       keyOf(1, {"a", "b"}, 1), keyOf(1, {"a", "b", ""})};
    EXPECT_EQ(keys.size(), 6U);
    EXPECT_EQ(keyOf(1, {"a", "b"}, 7), keyOf(1, {"a", "b"}, 7));
}

} // namespace
} // namespace trembler::insight
