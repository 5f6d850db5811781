// Searches for solutions of a level that nobody recorded.
#pragma once

#include "insight/ablation/needs.hpp"
#include "insight/kind/cause_graph.hpp"
#include "insight/spread/workers.hpp"
#include "insight/trial/level_under_test.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace trembler::insight {

struct SearchOptions {
    std::uint64_t runs = 2000; ///< trials; runs that find out what a found solution needs are not counted
    std::uint64_t seed = 1;
    std::uint64_t frames = 1200; ///< of a trial, at most: 20 s
    bool hands = true;           ///< whether to drag objects and cut wires as well
    /// Random placements only, for comparison: no places of interest, no nearest misses.
    bool random = false;
    /// Called after every generation, in every member of a team, with the trials so far.
    std::function<void(std::uint64_t runs, std::size_t kinds)> progress;
    /// The same, with all results so far, for a caller that shows them as they come.
    std::function<void(struct SearchResult const&)> sofar;
};

/// One kind of solution.
struct FoundSolution {
    Needs needs; ///< of the first solution of this kind; keep `needs.least`
    CauseGraph graph;
    std::uint64_t run = 0;   ///< the number of the trial that found it, from 1
    std::uint64_t times = 0; ///< trials that solved the level with the same parts and deeds
};

struct SearchResult {
    std::vector<FoundSolution> found; ///< in the order in which they were found
    std::uint64_t runs = 0;
    std::uint64_t solved = 0;                 ///< of them
    std::optional<std::uint64_t> firstSolved; ///< the number of the trial
    double nearest = 1;                       ///< the least miss of the trials that did not solve it
    Solution nearestMiss;
    std::size_t places = 0; ///< of interest
};

/// In generations of 16 to 64 runs: 0.3 of them place parts at random, 0.35 combine up to four parts in
/// places of interest and at random, the others change the nearest misses by the measure of MissMeter;
/// changes where a miss lacked something are frequent, no attempt is tried twice, and a miss counts as
/// farther off with each change that came no nearer. So does an attempt with the parts of a solution that is
/// known already, so that other kinds are looked for. Every found solution is reduced to what it needs, and
/// one of each kind is kept, see differ(). The result depends on the level, the options and the program only.
/// If the workers are stopped, it holds the solutions found so far.
[[nodiscard]] SearchResult searchFor(LevelUnderTest const& level, SearchOptions const& options,
                                     Workers& workers);

} // namespace trembler::insight
