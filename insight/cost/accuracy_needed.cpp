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

/// Runs all recorded runs of the level; returns the first run that does not end as recorded.
std::string firstDifference(LevelRuns const& runs, double& microseconds) {
    double spent = 0;
    std::uint64_t frames = 0;
    auto const look = [&](LevelRun const& run) {
        for (auto const& [effect, time] : timesOf(run.world())) {
            spent += time * static_cast<double>(run.world().frame());
        }
        frames += run.world().frame();
    };
    RunObserver observer;
    observer.end = look;
    std::string difference;
    RunResult const empty = runs.run({}, {.frames = handsOff}, observer);
    if (empty.fault) {
        return *empty.fault;
    }
    if (empty.solved != runs.level().demonstration) {
        difference = "hands off";
    }
    for (Solution const& solution : runs.level().solutions) {
        RunResult const result = runs.run({solution, {}}, {.frames = framesOf(solution)}, observer);
        if (result.solved != solution.solves && difference.empty()) {
            difference = solution.name;
        }
    }
    microseconds = frames == 0 ? 0 : spent / static_cast<double>(frames);
    return difference;
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

std::vector<EffectCost> effectCosts(LevelUnderTest const& level, Solution const& solution) {
    LevelRuns const runs(level.data(), level.level());
    std::vector<EffectCost> costs;
    RunObserver observer;
    observer.end = [&](LevelRun const& run) {
        for (auto const& [effect, time] : timesOf(run.world())) {
            costs.push_back({effect, time});
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
        keys.push_back(fmt::format("way/{}/{}/{}/{}", level.identity(), recorded, way.effect, way.level));
    }
    auto const results = workers.share(keys, [&](std::size_t index) {
        WayToCompute const& way = ways[index];
        std::string difference;
        double microseconds = 0;
        try {
            std::map<std::string, std::string> detail;
            if (substeps[index] == 0) {
                detail[way.effect] = way.level;
            }
            LevelRuns const runs(
                level.data(),
                substeps[index] == 0 ? level.level() : withSubsteps(level.level(), substeps[index]), detail);
            difference = firstDifference(runs, microseconds);
        } catch (InputError const& error) {
            difference = error.diagnostics().front().message;
        } catch (std::exception const& error) {
            difference = error.what();
        }
        return nlohmann::json{difference, microseconds}.dump();
    });
    std::vector<WayToCompute> done;
    for (std::size_t index = 0; index < ways.size(); ++index) {
        if (results[index]) {
            nlohmann::json const parsed = nlohmann::json::parse(*results[index]);
            ways[index].differs = parsed.at(0).get<std::string>();
            ways[index].keepsAll = ways[index].differs.empty();
            ways[index].microseconds = parsed.at(1).get<double>();
            done.push_back(ways[index]);
        }
    }
    return done;
}

} // namespace trembler::insight
