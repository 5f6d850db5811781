// No level that the schema allows crashes the program, on any engine: random levels, and every number of
// every property at the ends of its range. sweep_worlds tests any number of further levels.
#include "puzzle/goals/level_schema.hpp"
#include "tests/levels/level_kit.hpp"
#include "tests/levels/schema_validator.hpp"
#include "tests/support/sanitizer.hpp"
#include "tests/worlds/random_level.hpp"
#include "tests/worlds/trial.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace trembler::worlds {
namespace {

/// TREMBLER_FUZZ=50 makes fifty times as many levels; 0.1 a tenth.
std::size_t tries(std::size_t usual) {
    char const* const factor = std::getenv("TREMBLER_FUZZ");
    double const times = factor == nullptr ? 1 : std::strtod(factor, nullptr);
    return static_cast<std::size_t>(std::max(1.0, static_cast<double>(usual) * times));
}

nlohmann::json const& schema() {
    static nlohmann::json const made = levelSchema(levelKit().registry);
    return made;
}

RandomLevels const& levels() {
    static RandomLevels const made(schema(), levelKit().parts.names());
    return made;
}

void expectGood(nlohmann::json const& level, TrialOptions const& options, int& played) {
    Outcome const outcome = tryOut(level, schema(), options);
    played += outcome.played ? 1 : 0;
    for (Failure const& failure : outcome.failures) {
        ADD_FAILURE() << level.at("title") << ": " << inWords(failure) << "\n" << outcome.level.dump(1);
    }
}

/// Much more than sweep_worlds allows, so that a busy machine fails no test.
constexpr double frameSeconds = test::underSanitizer ? 60 : 10;

/// One case for each manner of levels, so that none of them takes long.
class RandomWorlds : public testing::TestWithParam<int> {};

TEST_P(RandomWorlds, NeitherBreakNorHangOnAnyEngine) {
    // Engines take long over many contacts in one place, so there are fewer of such levels.
    bool const crowded = mannerOf(static_cast<std::uint64_t>(GetParam())).spread < 1;
    std::size_t const count = tries(crowded ? 1 : 4);
    std::size_t const frames = test::underSanitizer ? (crowded ? 1 : 8) : (crowded ? 4 : 20);
    int played = 0;
    for (std::size_t i = 0; i < count; ++i) {
        expectGood(levels().make(8 * i + static_cast<std::size_t>(GetParam())),
                   {.frames = static_cast<int>(frames), .frameSeconds = frameSeconds}, played);
    }
    EXPECT_EQ(played, static_cast<int>(count));
}

INSTANTIATE_TEST_SUITE_P(Manner, RandomWorlds, testing::Range(0, 8));

TEST(RandomLevels, AreAcceptedByTheSchema) {
    for (std::uint64_t seed = 0; seed < tries(200); ++seed) {
        EXPECT_EQ(validate(schema(), levels().make(seed)), std::vector<std::string>()) << seed;
    }
}

TEST(RandomLevels, AreTheSameForTheSameSeed) {
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        EXPECT_EQ(levels().make(seed), levels().make(seed)) << seed;
    }
}

/// All levels of boundaries(), in a few cases.
class Boundaries : public testing::TestWithParam<std::size_t> {};
constexpr std::size_t cases = 6;

TEST_P(Boundaries, OfEveryNumberPlayOrAreRefusedWithAPlace) {
    std::vector<nlohmann::json> const all = levels().boundaries();
    ASSERT_GT(all.size(), 200U);
    std::size_t const step = std::max<std::size_t>(cases, cases * all.size() / tries(all.size()));
    int played = 0;
    for (std::size_t i = GetParam(); i < all.size(); i += step) {
        expectGood(all[i],
                   {.engines = {"box2d"}, .threads = {1, 2}, .frames = 6, .frameSeconds = frameSeconds},
                   played);
    }
}

INSTANTIATE_TEST_SUITE_P(Part, Boundaries, testing::Range(std::size_t{0}, cases));

} // namespace
} // namespace trembler::worlds
