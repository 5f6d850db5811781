#include "insight/robustness/place_map.hpp"
#include "insight/trial/trial.hpp"
#include "tests/insight/support/on_threads.hpp"
#include "tests/insight/support/tested_level.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace trembler::insight {
namespace {

/// How the first solution solves it, which lays a steel bar across a gap.
SolvedBy barAcross() {
    Solution const* const solution = firstContact().level().findSolution("the steel bar");
    return {solution, tryOut(firstContact(), *solution, {}).frame};
}

PlaceMap mapWith(PlaceMapOptions const& options, int threads) {
    Workers workers(onThreads(threads));
    auto const maps = placeMapsOf(firstContact(), {barAcross()}, options, workers);
    EXPECT_EQ(maps.front().size(), 1U);
    return maps.front().front();
}

/// What a run with the bar in that place of the map says.
char stateAt(PlaceMap const& map, std::size_t row, std::size_t column) {
    Solution moved = *barAcross().solution;
    Vec2 const by{static_cast<double>(column) - static_cast<double>(map.column),
                  static_cast<double>(map.row) - static_cast<double>(row)};
    moved.placements.front().at += map.step * by;
    TrialResult const result = tryOut(firstContact(), moved, {.frames = patienceFor(barAcross())});
    return !result.fits ? ' ' : result.solved ? '#' : '.';
}

TEST(PlaceMap, ReachesAsFarAsThePartSolvesTheLevel) {
    PlaceMap const map = mapWith({.step = 0.2, .places = 200}, 2);
    EXPECT_EQ(map.part, "steel bar");
    EXPECT_EQ(map.step, 0.2);
    EXPECT_EQ(map.rows[map.row][map.column], '#');
    // The bar falls onto the contacts from high above as well.
    EXPECT_GE(map.row, 6U) << "1 m above it and a row more";
    std::size_t solved = 0;
    for (std::size_t row = 0; row < map.rows.size(); ++row) {
        ASSERT_EQ(map.rows[row].size(), map.rows.front().size());
        for (std::size_t column = 0; column < map.rows[row].size(); ++column) {
            char const state = map.rows[row][column];
            bool const edge =
                row == 0 || column == 0 || row + 1 == map.rows.size() || column + 1 == map.rows[row].size();
            EXPECT_FALSE(edge && state == '#') << row << ", " << column;
            if (state == '#') {
                ++solved;
            }
            if (state != '-' && (row + column) % 3 == 0) { // some of them
                EXPECT_EQ(state, stateAt(map, row, column)) << row << ", " << column;
            }
        }
    }
    EXPECT_GT(solved, 10U);
    PlaceMap const again = mapWith({.step = 0.2, .places = 200}, 1);
    EXPECT_EQ(again.rows, map.rows);
    EXPECT_EQ(again.runs, map.runs);
}

TEST(PlaceMap, GetsCoarserInsteadOfLarger) {
    PlaceMap const map = mapWith({.step = 0.1, .places = 40}, 2);
    EXPECT_GT(map.step, 0.15);
    std::size_t shown = 0;
    for (std::string const& row : map.rows) {
        shown += static_cast<std::size_t>(
            std::count_if(row.begin(), row.end(), [](char state) { return state == '#' || state == '.'; }));
    }
    EXPECT_LE(shown, 40U);
    EXPECT_EQ(map.rows[map.row][map.column], '#');
}

TEST(PlaceMap, SaysWhatWasNotRunWhenItWasStopped) {
    Workers workers(onThreads(1, nullptr, nullptr, [] { return true; }));
    auto const maps = placeMapsOf(firstContact(), {barAcross()}, {}, workers);
    ASSERT_EQ(maps.front().size(), 1U);
    EXPECT_EQ(maps.front().front().rows[1], "???");
}

} // namespace
} // namespace trembler::insight
