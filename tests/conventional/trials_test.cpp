#include "tests/conventional/trials.hpp"
#include "tests/support/sanitizer.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace trembler::conventional {
namespace {

Stage const& stage() {
    static Stage const shared;
    return shared;
}

TEST(ConventionalScenes, AsDescribedAllAreRight) {
    std::vector<std::string> const expected{"lifted", "rings on", "open", "the way is free, alarm"};
    auto const scenes = allScenes();
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        Trial const trial = runDescribed(*scenes[i], stage());
        EXPECT_EQ(trial.right, expected[i]) << scenes[i]->title();
        EXPECT_EQ(trial.physical, expected[i]) << scenes[i]->title();
        for (std::string const& scripted : trial.scripted) {
            EXPECT_EQ(scripted, expected[i]) << scenes[i]->title();
        }
    }
}

TEST(ConventionalScenes, SameNumberSameTrial) {
    auto const scene = doorScene();
    Trial const once = runTrial(*scene, stage(), 3);
    Trial const again = runTrial(*scene, stage(), 3);
    EXPECT_EQ(once.kinds, again.kinds);
    EXPECT_EQ(once.physical, again.physical);
    EXPECT_EQ(once.scripted, again.scripted);
}

// The first perturbations of each scene; the target scripting_analysis runs all of them.
TEST(ConventionalScenes, FirstTrialsAreAsThePageSays) {
    std::vector<SceneResult> results;
    for (auto const& scene : allScenes()) {
        results.push_back(runTrials(*scene, stage(), test::underSanitizer ? 2 : shortCount));
    }
    if (test::underSanitizer) {
        return;
    }
    std::ifstream file(std::filesystem::path(TREMBLER_SOURCE_DIR) / "docs/scripting-analysis.md");
    std::string const page{std::istreambuf_iterator<char>(file), {}};
    std::string const table = firstTable(results, shortCount);
    EXPECT_NE(page.find(table), std::string::npos)
        << "docs/scripting-analysis.md has another table; this is the one of today:\n"
        << table;
}

// Values of a table of the binomial distribution's score intervals: 95 %.
TEST(ConventionalScenes, ConfidenceIntervalIsWilsons) {
    Share const half{.of = 50, .all = 100};
    EXPECT_NEAR(half.low(), 0.4038, 1e-4);
    EXPECT_NEAR(half.high(), 0.5962, 1e-4);
    Share const none{.of = 0, .all = 10};
    EXPECT_NEAR(none.low(), 0, 1e-12);
    EXPECT_NEAR(none.high(), 0.2775, 1e-4);
}

} // namespace
} // namespace trembler::conventional
