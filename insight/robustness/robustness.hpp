// How exactly a solution's parts must be placed, and its deeds done.
#pragma once

#include "insight/robustness/jitter.hpp"
#include "insight/spread/workers.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace trembler::insight {

struct RobustnessOptions {
    int runs = 200; ///< displaced runs of each solution
    Jitter jitter;
    std::uint64_t seed = 1;
};

/// How one run ended.
struct RunEnd {
    bool solved = false;
    std::uint64_t frame = 0; ///< in which it solved the level, else the last one
};

struct Robustness {
    int runs = 0; ///< that were made; fewer than asked for if the work was stopped
    int solved = 0;
    int redrawn = 0;            ///< displacements that no player could have made, see jittered()
    std::vector<RunEnd> ends{}; ///< of the runs, in the order of their numbers

    /// Of the runs, 0 to 1; 0 if there were none.
    [[nodiscard]] double share() const { return runs == 0 ? 0 : static_cast<double>(solved) / runs; }
};

/// A solution and the frame in which it solves its level.
struct SolvedBy {
    Solution const* solution = nullptr;
    std::uint64_t frame = 0;
};

/// For how long a displaced run may last: patience(), but never longer than the recording states.
[[nodiscard]] std::uint64_t patienceFor(SolvedBy const& solved);

/// Runs each solution with displaced placements and deeds. Run n of a solution has its own random numbers,
/// from the seed, the level, the solution and n, regardless of all names and texts. A solution of wires only,
/// or an empty one, gets no runs.
[[nodiscard]] std::vector<Robustness> robustnessOf(LevelUnderTest const& level,
                                                   std::vector<SolvedBy> const& solutions,
                                                   RobustnessOptions const& options, Workers& workers);

/// How often single parts solve the level when they are dropped anywhere.
struct Drop {
    std::string part;
    int runs = 0;
    int solved = 0;
    std::vector<RunEnd> ends{}; ///< of the runs, in the order of their numbers
    [[nodiscard]] double share() const { return runs == 0 ? 0 : static_cast<double>(solved) / runs; }
};

/// For each part of the toolbox: `runs` runs with it alone, in a random place where it overlaps nothing,
/// turned by a random multiple of 15 degrees. Where it would stick out of the areas for placing it solves
/// nothing. A part that fits nowhere gets no run.
[[nodiscard]] std::vector<Drop> randomDrops(LevelUnderTest const& level, int runs, std::uint64_t frames,
                                            std::uint64_t seed, Workers& workers);

} // namespace trembler::insight
