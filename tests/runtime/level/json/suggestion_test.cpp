#include "runtime/level/json/suggestion.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

namespace trembler {
namespace suggestion_test {
namespace {

std::set<std::string> neighboursOf(std::string const& word, bool swaps) {
    std::set<std::string> found;
    for (std::size_t i = 0; i <= word.size(); ++i) {
        for (char const letter : {'a', 'b', 'c'}) {
            found.insert(word.substr(0, i) + letter + word.substr(i));
            if (i < word.size()) {
                found.insert(word.substr(0, i) + letter + word.substr(i + 1));
            }
        }
        if (i < word.size()) {
            found.insert(word.substr(0, i) + word.substr(i + 1));
        }
        if (swaps && i + 1 < word.size()) {
            std::string swapped = word;
            std::swap(swapped[i], swapped[i + 1]);
            found.insert(swapped);
        }
    }
    return found;
}

/// The least number of steps from a word to each word within a distance, by exhaustive search.
std::map<std::string, std::size_t> stepsFrom(std::string const& word, std::size_t most, bool swaps) {
    std::map<std::string, std::size_t> steps{{word, 0}};
    std::set<std::string> front{word};
    for (std::size_t step = 1; step <= most; ++step) {
        std::set<std::string> next;
        for (std::string const& from : front) {
            for (std::string const& to : neighboursOf(from, swaps)) {
                if (steps.try_emplace(to, step).second) {
                    next.insert(to);
                }
            }
        }
        front = std::move(next);
    }
    return steps;
}

// Between the distances with arbitrary swaps and without swaps, because swapped letters are not edited again.
TEST(EditDistance, IsBetweenTheNumbersOfStepsWithAndWithoutSwaps) {
    int strictlyBelow = 0;
    for (std::string const word : {"", "a", "ab", "abc", "cab", "aabb"}) {
        auto const with = stepsFrom(word, 3, true);
        auto const without = stepsFrom(word, 3, false);
        for (auto const& [other, least] : with) {
            std::size_t const distance = editDistance(word, other);
            EXPECT_EQ(distance, editDistance(other, word));
            EXPECT_GE(distance, least) << word << " " << other;
            if (auto const most = without.find(other); most != without.end()) {
                EXPECT_LE(distance, most->second) << word << " " << other;
                strictlyBelow += distance < most->second ? 1 : 0;
            }
            if (least <= 1) { // a single step is one step in both
                EXPECT_EQ(distance, least) << word << " " << other;
            }
        }
    }
    EXPECT_GT(strictlyBelow, 10) << "swaps count";
    EXPECT_EQ(editDistance("ca", "abc"), 3U) << "2 with an insertion between swapped letters";
    EXPECT_EQ(editDistance("kitten", "sitting"), 3U);
    EXPECT_EQ(editDistance("ab", "ba"), 1U);
}

/// The recurrence as it is defined, for every pair of beginnings, without a limit.
std::size_t byDefinition(std::string const& a, std::string const& b) {
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t j = 0; j <= b.size(); ++j) {
            d[i][j] = std::max(i, j);
            if (i > 0 && j > 0) {
                std::size_t const change = a[i - 1] == b[j - 1] ? 0 : 1;
                d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + change});
            }
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
            }
        }
    }
    return d[a.size()][b.size()];
}

TEST(EditDistance, IsThatOfTheDefinitionUpToTheLimit) {
    std::mt19937 random(7);
    auto const anyWord = [&] {
        std::string word(random() % 9, 'a');
        for (char& letter : word) {
            letter = static_cast<char>('a' + random() % 3);
        }
        return word;
    };
    for (int i = 0; i < 20'000; ++i) {
        std::string const a = anyWord();
        std::string const b = anyWord();
        std::size_t const distance = byDefinition(a, b);
        ASSERT_EQ(editDistance(a, b), distance) << a << " " << b;
        for (std::size_t limit = 0; limit < 10; ++limit) {
            ASSERT_EQ(editDistance(a, b, limit), std::min(distance, limit)) << a << " " << b << " " << limit;
        }
    }
}

TEST(Suggestion, FindsTypingErrorsAndNothingElse) {
    std::vector<std::string> const known{"friction", "fixed", "density", "mass"};
    EXPECT_EQ(suggestion("fricton", known), "friction");
    EXPECT_EQ(suggestion("desnity", known), "density");
    EXPECT_EQ(suggestion("fixd", known), "fixed");
    EXPECT_EQ(suggestion("colour", known), std::nullopt);
    EXPECT_EQ(suggestion("", known), std::nullopt);
    EXPECT_EQ(editDistance("kitten", "sitting"), 3U);
    EXPECT_EQ(editDistance("ab", "ba"), 1U);
}

TEST(Suggestion, IsTheNearestAndTheFirstOfEquals) {
    std::vector<std::string> const known{"mask", "masc", "mast", "mass"};
    EXPECT_EQ(suggestion("mas", known), "mask");
    EXPECT_EQ(suggestion("mass", known), "mass");
    EXPECT_EQ(suggestion("mass", {}), std::nullopt);
    EXPECT_EQ(didYouMean("masz", known), " (did you mean 'mask'?)");
    EXPECT_EQ(didYouMean("velocity", known), "");
    std::vector<std::string> const longWord{std::string(101, 'x')};
    EXPECT_EQ(suggestion(std::string(100, 'x'), longWord), longWord[0]);
    EXPECT_EQ(suggestion(longWord[0], longWord), std::nullopt) << "too long for a typing error";
}

TEST(Suggestion, ListsAreShortened) {
    EXPECT_EQ(listed({}), "");
    std::vector<std::string> words{"a"};
    EXPECT_EQ(listed(words), "'a'");
    words.emplace_back("b");
    EXPECT_EQ(listed(words), "'a' or 'b'");
    words.emplace_back("c");
    EXPECT_EQ(listed(words), "'a', 'b' or 'c'");
    words.resize(30, "z");
    EXPECT_TRUE(listed(words).ends_with("'z' or 'z'"));
    words.emplace_back("last");
    EXPECT_TRUE(listed(words).ends_with("'z', 'z', ...")) << listed(words);
}

} // namespace
} // namespace suggestion_test
} // namespace trembler
