#include "insight/search/search.hpp"
#include "insight/trial/solution_text.hpp"
#include "insight/trial/trial.hpp"
#include "tests/insight/support/on_threads.hpp"
#include "tests/insight/support/tested_level.hpp"
#include "tests/insight/support/threaded_team.hpp"
#include "tests/support/sanitizer.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <set>

namespace trembler::insight {
namespace {

/// The results of a search, without its time.
std::string told(SearchResult const& result) {
    std::string text = std::to_string(result.runs) + " " + std::to_string(result.solved) + " " +
                       std::to_string(result.firstSolved.value_or(0)) + " " + toText(result.nearestMiss);
    for (FoundSolution const& found : result.found) {
        text += "\n" + std::to_string(found.run) + " " + std::to_string(found.times) + " " +
                toText(found.needs) + toText(found.graph);
    }
    return text;
}

SearchOptions shortSearch() {
    SearchOptions options;
    options.runs = 150;
    options.frames = 600;
    options.seed = 3;
    return options;
}

TEST(Search, FindsBothPartsThatCloseTheCircuit) {
    Workers workers(onThreads(2));
    SearchResult const result = searchFor(firstContact(), shortSearch(), workers);
    EXPECT_EQ(result.runs, 150U);
    EXPECT_GT(result.solved, 1U);
    std::set<std::string> alone;
    for (FoundSolution const& found : result.found) {
        TrialResult const again = tryOut(firstContact(), found.needs.least, {.frames = 600});
        EXPECT_TRUE(again.fits);
        EXPECT_TRUE(again.solved) << "each is a solution that a player can play";
        EXPECT_GE(found.times, 1U);
        if (found.needs.parts.size() == 1 && found.needs.deeds.empty()) {
            alone.insert(found.needs.parts.front());
        }
    }
    EXPECT_TRUE(alone.contains("steel bar"));
    EXPECT_TRUE(alone.contains("spanner"));
    EXPECT_FALSE(alone.contains("wooden bar"));
}

TEST(Search, FindsTheSameWithAnyNumberOfThreadsAndMembers) {
    SearchOptions options = shortSearch();
    options.runs = test::underSanitizer ? 60 : options.runs;
    Workers one(onThreads(1));
    std::string const expected = told(searchFor(firstContact(), options, one));
    Workers three(onThreads(3));
    EXPECT_EQ(told(searchFor(firstContact(), options, three)), expected);
    std::mutex mutex;
    ThreadedTeam::run(3, [&](Team& team) {
        Workers workers(onThreads(1, &team));
        std::string const mine = told(searchFor(firstContact(), options, workers));
        std::lock_guard const lock(mutex);
        EXPECT_EQ(mine, expected) << "member " << team.rank();
    });
    SearchOptions other = options;
    other.seed = 4;
    EXPECT_NE(told(searchFor(firstContact(), other, one)), expected);
}

TEST(Search, AtRandomOnlyPlacesParts) {
    SearchOptions options = shortSearch();
    options.random = true;
    Workers workers(onThreads(2));
    SearchResult const result = searchFor(firstContact(), options, workers);
    EXPECT_EQ(result.runs, 150U);
    for (FoundSolution const& found : result.found) {
        EXPECT_TRUE(found.needs.deeds.empty());
    }
}

TEST(Search, ThatIsStoppedTellsWhatItHas) {
    std::atomic<int> asked{0};
    Workers workers(onThreads(1, nullptr, nullptr, [&] { return ++asked > 40; }));
    SearchResult const result = searchFor(firstContact(), shortSearch(), workers);
    EXPECT_TRUE(workers.stopped());
    EXPECT_GT(result.runs, 20U);
    EXPECT_LT(result.runs, 41U);
}

} // namespace
} // namespace trembler::insight
