#include "insight/cost/accuracy_needed.hpp"

#include "insight/run/level_runs.hpp"
#include "insight/trial/solution_text.hpp"
#include "insight/trial/text_hash.hpp"
#include "insight/trial/trial.hpp"
#include "physics/dynamics/properties/settings.hpp"
#include "runtime/level/json/diagnostic.hpp"
#include "runtime/level/model/detail_levels.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <set>

namespace trembler::insight {
namespace {

constexpr std::uint64_t handsOff = 3600; // frames, as `trembler verify` waits
constexpr int substepsTried[] = {1, 2, 4, 8};

/// µs per frame, by effect.
std::map<std::string, double> timesOf(World const& world) {
    std::map<std::string, double> times;
    auto const frames = static_cast<double>(std::max<std::uint64_t>(1, world.frame()));
    for (ComponentStatus const& status : world.status()) {
        if (status.activity != Activity::absent) {
            times[std::string(status.info->text.effect)] += status.totalMicroseconds / frames;
        }
    }
    return times;
}

struct Outcome {
    std::string differs;     ///< the first run that does not end as recorded
    double microseconds = 0; ///< per frame, in the measured run
    std::uint64_t frames = 0;
};

/// Runs all recorded runs of the level, which LevelRuns itself does not keep, and one without input. Measures
/// the same run as effectCosts() for measuredRun(): the mean over all runs would be of another kind of frame,
/// as nothing moves for most of the minute hands off, and such frames cost nearly nothing.
Outcome outcomeOf(LevelRuns const& runs, LevelFile const& level) {
    Outcome outcome;
    RunObserver measuring;
    measuring.end = [&outcome](LevelRun const& run) {
        for (auto const& [effect, time] : timesOf(run.world())) {
            outcome.microseconds += time;
        }
        outcome.frames = run.world().frame();
    };
    std::size_t const measured = measuredRun(level);
    auto const observerOf = [&](std::size_t index) { return index == measured ? measuring : RunObserver{}; };
    RunResult const empty = runs.run({}, {.frames = handsOff}, observerOf(level.solutions.size()));
    if (empty.fault) {
        outcome.differs = *empty.fault;
        return outcome;
    }
    if (empty.solved != level.demonstration) {
        outcome.differs = "hands off";
    }
    for (std::size_t i = 0; i < level.solutions.size(); ++i) {
        Solution const& solution = level.solutions[i];
        RunResult const result = runs.run({solution, {}}, {.frames = framesOf(solution)}, observerOf(i));
        if (result.solved != solution.solves && outcome.differs.empty()) {
            outcome.differs = solution.name;
        }
    }
    return outcome;
}

LevelFile withSubsteps(LevelFile level, int substeps) {
    DynamicsSettings settings;
    if (auto const* const stated = level.world.find<DynamicsSettings>()) {
        settings = *stated;
    }
    settings.substeps = substeps;
    level.world.set(settings);
    return level;
}

/// The effects at work, with the names of the detail levels that they have now.
std::map<std::string, std::string> presentLevels(LevelUnderTest const& level) {
    std::map<std::string, std::string> present;
    for (ComponentStatus const& status : level.world().status()) {
        if (status.activity != Activity::absent && !status.info->text.level.empty()) {
            present[std::string(status.info->text.effect)] = status.info->text.level;
        }
    }
    return present;
}

/// For keys of work that runs all solutions and whose result may name one of them.
std::string everythingRecorded(LevelFile const& level) {
    std::string text;
    for (Solution const& solution : level.solutions) {
        text += nlohmann::json{solution.name, identityOf(solution), solution.solves}.dump();
    }
    return hashOf(text);
}

} // namespace

std::size_t measuredRun(LevelFile const& level) {
    auto const first = std::find_if(level.solutions.begin(), level.solutions.end(),
                                    [](Solution const& solution) { return solution.solves; });
    return static_cast<std::size_t>(first - level.solutions.begin());
}

std::vector<EffectCost> effectCosts(LevelUnderTest const& level, Solution const& solution) {
    LevelRuns const runs(level.data(), level.level());
    std::vector<EffectCost> costs;
    RunObserver observer;
    observer.end = [&](LevelRun const& run) {
        for (auto const& [effect, time] : timesOf(run.world())) {
            costs.push_back({effect, time, run.world().frame()});
        }
    };
    (void)runs.run({solution, {}}, {.frames = framesOf(solution)}, observer);
    std::stable_sort(costs.begin(), costs.end(), [](EffectCost const& a, EffectCost const& b) {
        return a.microseconds > b.microseconds;
    });
    return costs;
}

std::vector<WayToCompute> waysToCompute(LevelUnderTest const& level, Workers& workers) {
    std::vector<WayToCompute> ways;
    std::vector<int> substeps;
    auto levelsOf = detailLevels(level.data().registry);
    for (auto const& [effect, present] : presentLevels(level)) {
        for (std::string const& name : levelsOf[effect]) {
            ways.push_back({effect, name, name == present});
            substeps.push_back(0);
        }
    }
    auto const* const settings = level.level().world.find<DynamicsSettings>();
    for (int const count : substepsTried) {
        bool const present = settings != nullptr && settings->substeps == count;
        ways.push_back({"dynamics", fmt::format("{} substep{}", count, count == 1 ? "" : "s"), present});
        substeps.push_back(count);
    }
    std::string const recorded = everythingRecorded(level.level());
    std::vector<std::string> keys;
    for (WayToCompute const& way : ways) {
        keys.push_back(
            fmt::format("cost of a way/{}/{}/{}/{}", level.identity(), recorded, way.effect, way.level));
    }
    auto const results = workers.share(keys, [&](std::size_t index) {
        WayToCompute const& way = ways[index];
        Outcome outcome;
        try {
            std::map<std::string, std::string> detail;
            if (substeps[index] == 0) {
                detail[way.effect] = way.level;
            }
            LevelRuns const runs(
                level.data(),
                substeps[index] == 0 ? level.level() : withSubsteps(level.level(), substeps[index]), detail);
            outcome = outcomeOf(runs, level.level());
        } catch (InputError const& error) {
            outcome.differs = error.diagnostics().front().message;
        } catch (std::exception const& error) {
            outcome.differs = error.what();
        }
        return nlohmann::json{outcome.differs, outcome.microseconds, outcome.frames}.dump();
    });
    std::vector<WayToCompute> done;
    for (std::size_t index = 0; index < ways.size(); ++index) {
        if (results[index]) {
            nlohmann::json const parsed = nlohmann::json::parse(*results[index]);
            ways[index].differs = parsed.at(0).get<std::string>();
            ways[index].keepsAll = ways[index].differs.empty();
            ways[index].microseconds = parsed.at(1).get<double>();
            ways[index].frames = parsed.at(2).get<std::uint64_t>();
            done.push_back(ways[index]);
        }
    }
    return done;
}

} // namespace trembler::insight
