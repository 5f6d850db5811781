// The executor with more threads than cores: runs every task once, in the order of the graph, and passes
// errors on.
#include "runtime/schedule/executor.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <atomic>
#include <memory>
#include <numeric>
#include <set>
#include <stdexcept>
#include <thread>

namespace trembler {
namespace {

TEST(ExecutorThreads, VisitEveryIndexOnce) {
    for (int const threads : {1, 2, 3, 8, 32}) {
        Executor executor(threads);
        EXPECT_EQ(executor.threads(), threads);
        for (std::size_t const count : {0U, 1U, 2U, 7U, 1000U}) {
            std::vector<std::atomic<int>> visits(count);
            executor.forIndices(count, [&](std::size_t i) { ++visits[i]; });
            for (std::size_t i = 0; i < count; ++i) {
                EXPECT_EQ(visits[i].load(), 1) << i << " of " << count << " on " << threads;
            }
        }
    }
}

TEST(ExecutorThreads, AreAtLeastOne) {
    EXPECT_EQ(Executor(0).threads(), 1);
}

// Every node records its start and end by a common counter.
TEST(ExecutorThreads, RespectTheOrderOfRandomGraphs) {
    Executor executor(8);
    EXPECT_TRUE(rc::check([&] {
        auto const count = *rc::gen::inRange<std::size_t>(1, 24);
        std::set<std::pair<std::size_t, std::size_t>> wanted;
        auto const tries = *rc::gen::inRange<std::size_t>(0, 60);
        for (std::size_t t = 0; t < tries && count > 1; ++t) {
            auto const after = *rc::gen::inRange<std::size_t>(1, count);
            wanted.emplace(*rc::gen::inRange<std::size_t>(0, after), after);
        }
        std::vector<std::pair<std::size_t, std::size_t>> const edges(wanted.begin(), wanted.end());
        std::atomic<int> clock{0};
        std::vector<int> begun(count, -1);
        std::vector<int> ended(count, -1);
        std::vector<std::atomic<int>> runs(count);
        executor.runGraph(count, edges, [&](std::size_t i) {
            begun[i] = ++clock;
            ++runs[i];
            ended[i] = ++clock;
        });
        for (std::size_t i = 0; i < count; ++i) {
            RC_ASSERT(runs[i].load() == 1);
        }
        for (auto const& [before, after] : edges) {
            RC_ASSERT(ended[before] < begun[after]);
        }
    }));
}

TEST(ExecutorThreads, WritesBeforeAnEdgeAreSeenAfterIt) {
    // A chain in which every node reads, without a lock, the value written by the previous one; the thread
    // sanitizer checks this, too.
    Executor executor(8);
    constexpr std::size_t count = 64;
    std::vector<std::pair<std::size_t, std::size_t>> edges;
    for (std::size_t i = 1; i < count; ++i) {
        edges.emplace_back(i - 1, i);
    }
    std::vector<std::uint64_t> values(count, 0);
    executor.runGraph(count, edges, [&](std::size_t i) { values[i] = i == 0 ? 1 : values[i - 1] + 1; });
    EXPECT_EQ(values.back(), count);
}

TEST(ExecutorThreads, PassExceptionsOnAndContinueToWork) {
    for (int const threads : {1, 2, 8}) {
        Executor executor(threads);
        auto const failing = [](std::size_t i) {
            if (i == 5) {
                throw std::runtime_error("number five");
            }
        };
        for (int again = 0; again < 3; ++again) {
            EXPECT_THROW(executor.forIndices(100, failing), std::runtime_error) << threads;
            std::vector<std::pair<std::size_t, std::size_t>> const edges = {{0, 5}, {5, 6}, {6, 7}};
            try {
                executor.runGraph(100, edges, failing);
                FAIL() << "the exception was lost on " << threads << " threads";
            } catch (std::runtime_error const& error) {
                EXPECT_STREQ(error.what(), "number five");
            }
            std::atomic<int> done{0};
            executor.runGraph(10, edges, [&](std::size_t) { ++done; });
            executor.forIndices(10, [&](std::size_t) { ++done; });
            EXPECT_EQ(done.load(), 20);
        }
    }
}

TEST(ExecutorThreads, NothingAfterAFailedNodeRuns) {
    Executor executor(4);
    std::atomic<bool> ran{false};
    std::vector<std::pair<std::size_t, std::size_t>> const edges = {{0, 1}, {1, 2}};
    auto const f = [&](std::size_t i) {
        if (i == 0) {
            throw std::runtime_error("first");
        }
        ran = true;
    };
    EXPECT_THROW(executor.runGraph(3, edges, f), std::runtime_error);
    EXPECT_FALSE(ran.load());
}

TEST(ExecutorThreads, MayBeUsedFromWithinTheirOwnTasks) {
    Executor executor(8);
    std::vector<std::vector<int>> results(16, std::vector<int>(500, 0));
    std::vector<std::pair<std::size_t, std::size_t>> const edges = {{0, 8}, {1, 8}, {8, 15}};
    executor.runGraph(results.size(), edges, [&](std::size_t node) {
        executor.forIndices(500,
                            [&, node](std::size_t i) { results[node][i] += static_cast<int>(node + i); });
    });
    for (std::size_t node = 0; node < results.size(); ++node) {
        for (std::size_t i = 0; i < 500; ++i) {
            ASSERT_EQ(results[node][i], static_cast<int>(node + i));
        }
    }
}

TEST(ExecutorThreads, TwoExecutorsOfDifferentSizesAreIndependent) {
    auto small = std::make_unique<Executor>(2);
    Executor large(32);
    std::atomic<int> sum{0};
    large.forIndices(100, [&](std::size_t) { small->forIndices(10, [&](std::size_t) { ++sum; }); });
    // A small executor does not limit the other one: three tasks of that can wait for one another.
    std::atomic<int> here{0};
    std::atomic<int> met{0};
    large.forIndices(3, [&](std::size_t) {
        ++here;
        while (here.load() < 3) { // without a time limit, because the machine may be busy
            std::this_thread::yield();
        }
        met += here.load() == 3 ? 1 : 0;
    });
    EXPECT_EQ(met.load(), 3);
    small.reset();
    large.forIndices(100, [&](std::size_t) { ++sum; });
    EXPECT_EQ(sum.load(), 1100);
}

} // namespace
} // namespace trembler
