// Names of objects that are created while a world runs: only generated names are recognised.
#include "runtime/population/birth_name.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <limits>
#include <regex>

namespace trembler {
namespace {

TEST(BirthName, IsThePartTheMakerAndTheNumber) {
    EXPECT_EQ(birthName("bullet", "cannon", 3), "bullet of cannon 3");
    EXPECT_EQ(birthName("bullet", "cannon", 3, 2), "bullet of cannon 3 (2)");
    EXPECT_EQ(birthName("spark", "bullet of cannon 3", 0), "spark of bullet of cannon 3 0");
}

TEST(BirthName, IsRecognisedForAnyNamesOfPartAndMaker) {
    EXPECT_TRUE(rc::check(
        [](std::string const& part, std::string const& maker, std::uint64_t number, std::uint64_t attempt) {
            RC_PRE(!part.empty() && !maker.empty());
            RC_ASSERT(isBirthName(birthName(part, maker, number)));
            RC_ASSERT(isBirthName(birthName(part, maker, number, attempt)));
        }));
    std::uint64_t const most = std::numeric_limits<std::uint64_t>::max();
    EXPECT_TRUE(isBirthName(birthName("a", "b", most, most)));
    EXPECT_TRUE(isBirthName(birthName(" of ", " of ", 1)));
}

// The same rule as a regular expression.
TEST(BirthName, IsRecognisedByItsRuleAlone) {
    std::regex const rule(R"([^]+ of [^]+ (0|[1-9][0-9]*)( \(([2-9]|[1-9][0-9]+)\))?)");
    std::vector<std::string> const words{"a", "of", " ", " ", " of ", "0",   "1",
                                         "2", "10", "(", ")", " 7",   " (2)"};
    EXPECT_TRUE(rc::check([&](std::vector<std::uint8_t> const& picks) {
        std::string name;
        for (std::uint8_t const pick : picks) {
            name += words[pick % words.size()];
            bool const numberFits = name.find_first_of("0123456789") + 15 > name.size();
            RC_ASSERT(!numberFits || isBirthName(name) == std::regex_match(name, rule));
        }
    }));
    for (char const* const other :
         {"", " of ", " of  1", "king of hearts", "ball of 3", " of cannon 3", "bullet of cannon",
          "bullet of cannon 03", "bullet of cannon 3 (1)", "bullet of cannon 3 (02)", "bullet of cannon 3(2)",
          "bullet of cannon 18446744073709551616", "ball 3", "bullet of cannon -3", "bullet of cannon 3 "}) {
        EXPECT_FALSE(isBirthName(other)) << other;
    }
}

} // namespace
} // namespace trembler
