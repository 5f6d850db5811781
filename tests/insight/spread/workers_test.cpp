#include "insight/spread/workers.hpp"
#include "tests/insight/support/on_threads.hpp"
#include "tests/insight/support/threaded_team.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <stdexcept>

namespace trembler::insight {
namespace {

std::vector<std::string> numbered(std::size_t count) {
    std::vector<std::string> keys;
    for (std::size_t i = 0; i < count; ++i) {
        keys.push_back("piece " + std::to_string(i));
    }
    return keys;
}

std::string square(std::size_t i) {
    return std::to_string(i * i);
}

TEST(Workers, GiveTheSameWithAnyNumberOfThreadsAndMembers) {
    std::vector<std::string> const keys = numbered(100);
    Workers one(onThreads(1));
    auto const expected = one.share(keys, square);
    EXPECT_EQ(expected[9], "81");
    EXPECT_EQ(one.done(), 100U);
    Workers many(onThreads(8));
    EXPECT_EQ(many.share(keys, square), expected);
    for (int const size : {2, 3, 7}) {
        std::atomic<int> calls{0};
        ThreadedTeam::run(size, [&](Team& team) {
            Workers workers(onThreads(2, &team));
            EXPECT_EQ(workers.share(keys, [&](std::size_t i) { return ++calls, square(i); }), expected);
            EXPECT_EQ(workers.done(), 100U);
        });
        EXPECT_EQ(calls, 100) << "no piece is done twice";
    }
    EXPECT_TRUE(many.share({}, square).empty());
}

TEST(Workers, StopBetweenPieces) {
    std::atomic<int> calls{0};
    Workers workers(onThreads(1, nullptr, nullptr, [&] { return calls >= 5; }));
    auto const results = workers.share(numbered(20), [&](std::size_t i) { return ++calls, square(i); });
    EXPECT_TRUE(workers.stopped());
    EXPECT_EQ(calls, 5);
    EXPECT_EQ(results[4], "16");
    EXPECT_FALSE(results[5].has_value());
    // In a team all members learn that one was stopped.
    ThreadedTeam::run(3, [&](Team& team) {
        Workers member(onThreads(1, &team, nullptr, [&] { return team.rank() == 1; }));
        auto const shared = member.share(numbered(9), square);
        EXPECT_TRUE(member.stopped());
        EXPECT_FALSE(shared[1].has_value());
        EXPECT_EQ(shared[8], "64");
    });
}

TEST(Workers, ReportTheFirstFailureToEverybody) {
    auto const fails = [](std::size_t i) -> std::string {
        if (i % 4 == 3) {
            throw std::runtime_error("piece " + std::to_string(i) + " is broken");
        }
        return square(i);
    };
    auto const problemOf = [&](Workers& workers) -> std::string {
        try {
            (void)workers.share(numbered(12), fails);
        } catch (std::runtime_error const& error) {
            return error.what();
        }
        return "";
    };
    Workers alone(onThreads(1));
    EXPECT_EQ(problemOf(alone), "piece 3 is broken");
    ThreadedTeam::run(2, [&](Team& team) {
        Workers member(onThreads(1, &team));
        EXPECT_EQ(problemOf(member), "piece 3 is broken");
    });
}

TEST(Workers, GoOnWithWhatAJournalHas) {
    std::filesystem::path const file = std::filesystem::temp_directory_path() / "trembler-workers-test.jsonl";
    for (char const* ending : {"", ".1", ".2"}) {
        std::filesystem::remove(file.string() + ending);
    }
    std::vector<std::string> const keys = numbered(30);
    std::atomic<int> calls{0};
    auto const counted = [&](std::size_t i) { return ++calls, square(i); };
    {
        Team team;
        Journal journal(file, team);
        Workers workers(onThreads(1, nullptr, &journal, [&] { return calls >= 10; }));
        (void)workers.share(keys, counted);
    }
    ThreadedTeam::run(3, [&](Team& team) {
        Journal journal(file, team);
        EXPECT_EQ(journal.size(), 10U);
        Workers workers(onThreads(1, &team, &journal));
        EXPECT_EQ(workers.share(keys, counted)[29], "841");
    });
    EXPECT_EQ(calls, 30) << "10 before it was stopped, 20 afterwards";
    Team team;
    EXPECT_EQ(Journal(file, team).size(), 30U) << "those of all members";
    for (char const* ending : {"", ".1", ".2"}) {
        std::filesystem::remove(file.string() + ending);
    }
}

} // namespace
} // namespace trembler::insight
