// Runs variations of one level, without a window.
#pragma once

#include "insight/run/variation.hpp"
#include "puzzle/data/game_data.hpp"
#include "puzzle/session/run.hpp"

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace trembler::insight {

struct RunLimits {
    std::uint64_t frames = 3600; ///< at most, 1/60 s each
    bool stopWhenSolved = true;
    bool trace = false; ///< gather the events of the run, for World::tracer()
};

/// Observers of a run, which must change nothing; each may be empty. The run is valid during the call only.
struct RunObserver {
    std::function<void(LevelRun const&)> begin; ///< before the first frame
    std::function<bool(LevelRun const&)> frame; ///< after every frame; false ends the run
    std::function<void(LevelRun const&)> end;   ///< after the last frame; not after a fault
};

struct RunResult {
    /// Why the variation cannot be run, in words: a goal is about an object that was left out. The rest is
    /// then empty.
    std::optional<std::string> fault;
    std::uint64_t frames = 0; ///< computed
    bool solved = false;
    std::optional<std::uint64_t> solvedFrame;
    std::vector<GoalStatus> goals; ///< in the level's order, after the last frame
    std::uint64_t stateHash = 0;
};

/// Runs with this level. run() is a pure function of the constructor's and its own arguments, and may be
/// called from several threads at once.
class LevelRuns {
public:
    /// `data` must outlive it. `detail` overrides the detail levels that the level states.
    LevelRuns(GameData const& data, LevelFile level, std::map<std::string, std::string> const& detail = {});
    /// With the registry and parts of a program without mods. Both must outlive it.
    LevelRuns(Registry const& registry, PartLibrary const& parts, LevelFile level);
    LevelRuns(LevelRuns const&) = delete;
    LevelRuns& operator=(LevelRuns const&) = delete;

    /// Runs a variation on one thread until it is solved, the limit is reached or the observer ends it.
    /// Placements are not checked against the toolbox, or for overlaps: they are those of a run that was
    /// possible, or the caller's own (see Session::check()). An index or a name that does not exist, and
    /// anything else that prevents the run, becomes RunResult::fault. An input is left out if it names an
    /// object that does not exist in this run.
    [[nodiscard]] RunResult run(Variation const& variation, RunLimits const& limits,
                                RunObserver const& observer = {}) const;

    [[nodiscard]] LevelFile const& level() const { return level_; }
    /// How long to run a solution that should solve the level: as long as it states, else a minute.
    [[nodiscard]] static std::uint64_t framesFor(Solution const& solution);

private:
    /// The versions of scripts that count in the real run, in a registry that was made from the mods as they
    /// were read.
    void carryOver(lua::LiveScripts const& to, Problems& problems) const;
    [[nodiscard]] Registry const& registryWithout(std::set<std::string> const& effects) const;

    Registry const& registry_;
    PartLibrary const& parts_;
    GameData const* data_; // nullptr: no mods
    LevelFile level_;
    // By the effects that are left out; made when first needed.
    mutable std::mutex registriesMutex_;
    mutable std::map<std::set<std::string>, std::unique_ptr<Registry>> registries_;
};

} // namespace trembler::insight
