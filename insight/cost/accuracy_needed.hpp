// The cost of each effect in a level, and how exactly the level must be computed to keep its verdicts.
#pragma once

#include "insight/spread/workers.hpp"
#include "insight/trial/level_under_test.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace trembler::insight {

/// By the world's own measurement; differs from run to run and from machine to machine.
struct EffectCost {
    std::string effect;
    double microseconds = 0;  ///< per frame, mean over the run
    std::uint64_t frames = 0; ///< of the run
};

/// Which of the level's recorded solutions is run to measure costs: the first that solves it. The number of
/// solutions if there is none: then the run without input is measured.
[[nodiscard]] std::size_t measuredRun(LevelFile const& level);

/// The effects at work in a run of the solution, the most expensive first. Not shared out and never from a
/// journal, as other threads would disturb the measurement.
[[nodiscard]] std::vector<EffectCost> effectCosts(LevelUnderTest const& level, Solution const& solution);

/// A way to compute the level, and whether every recorded run still ends as recorded.
struct WayToCompute {
    std::string effect;    ///< "dynamics"
    std::string level;     ///< a detail level, or "2 substeps"
    bool present = false;  ///< it is the one that the level has now
    bool keepsAll = false; ///< every recorded run, and the run without input, has the same verdict
    std::string differs{}; ///< the first run with another verdict, or why no world can be built
    /// Per frame of measuredRun(), of all effects together: to be compared with the sum of effectCosts().
    /// Differs from run to run.
    double microseconds = 0;
    std::uint64_t frames = 0; ///< of that run; it may be solved in another frame
};

/// All detail levels of all effects at work in the level, and 1, 2, 4 and 8 substeps, each with all other
/// settings unchanged.
[[nodiscard]] std::vector<WayToCompute> waysToCompute(LevelUnderTest const& level, Workers& workers);

} // namespace trembler::insight
