#include "insight/robustness/robustness.hpp"

#include "insight/search/random_placement.hpp"
#include "insight/trial/solution_text.hpp"
#include "insight/trial/trial.hpp"
#include "puzzle/session/zone.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace trembler::insight {
namespace {

/// The text that identifies a solution in keys. The name distinguishes two solutions of equal content.
std::string nameInKeys(LevelUnderTest const& level, Solution const& solution, std::uint64_t frames) {
    return fmt::format("{}/{}/{}/{}", level.identity(), identityOf(solution), solution.name, frames);
}

} // namespace

std::uint64_t patienceFor(SolvedBy const& solved) {
    return patience(solved.frame, framesOf(*solved.solution));
}

std::vector<Robustness> robustnessOf(LevelUnderTest const& level, std::vector<SolvedBy> const& solutions,
                                     RobustnessOptions const& options, Workers& workers) {
    struct Run {
        std::size_t solution;
        std::uint64_t number;
    };
    std::vector<Run> runs;
    std::vector<std::string> keys;
    for (std::size_t i = 0; i < solutions.size(); ++i) {
        Solution const& solution = *solutions[i].solution;
        int const count = canBeDisplaced(solution) ? options.runs : 0;
        for (int n = 0; n < count; ++n) {
            runs.push_back({i, static_cast<std::uint64_t>(n)});
            keys.push_back(fmt::format(
                "robustness/{}/{}/{}/{}/{}/{}", nameInKeys(level, solution, patienceFor(solutions[i])),
                options.seed, options.jitter.distance, options.jitter.angle, options.jitter.seconds, n));
        }
    }
    auto const results = workers.share(keys, [&](std::size_t index) {
        Run const& run = runs[index];
        SolvedBy const& solved = solutions[run.solution];
        CounterRandom random(
            keyOf(options.seed, {"robustness", level.identity(), identityOf(*solved.solution)}, run.number));
        int redrawn = 0;
        auto const displaced = jittered(level, *solved.solution, options.jitter, random, redrawn);
        TrialResult result;
        if (displaced) {
            result = tryOut(level, *displaced, {.frames = patienceFor(solved), .mustFit = false});
        }
        return nlohmann::json{displaced.has_value(), result.solved, redrawn, result.frame}.dump();
    });
    std::vector<Robustness> found(solutions.size());
    for (std::size_t index = 0; index < runs.size(); ++index) {
        if (!results[index]) {
            continue;
        }
        nlohmann::json const parsed = nlohmann::json::parse(*results[index]);
        Robustness& robustness = found[runs[index].solution];
        robustness.redrawn += parsed.at(2).get<int>();
        if (parsed.at(0).get<bool>()) {
            robustness.ends.push_back({parsed.at(1).get<bool>(), parsed.at(3).get<std::uint64_t>()});
            ++robustness.runs;
            robustness.solved += robustness.ends.back().solved ? 1 : 0;
        }
    }
    return found;
}

std::vector<Drop> randomDrops(LevelUnderTest const& level, int runs, std::uint64_t frames, std::uint64_t seed,
                              Workers& workers) {
    std::vector<Drop> drops;
    std::vector<std::string> keys;
    for (ToolboxEntry const& entry : level.level().toolbox) {
        drops.push_back({entry.part});
        for (int n = 0; n < runs; ++n) {
            keys.push_back(fmt::format("drop/{}/{}/{}/{}/{}", level.identity(), entry.part, frames, seed, n));
        }
    }
    auto const each = static_cast<std::size_t>(std::max(1, runs));
    auto const results = workers.share(keys, [&](std::size_t index) {
        std::string const& part = drops[index / each].part;
        CounterRandom random(keyOf(seed, {"drop", level.identity(), part}, index % each));
        Solution solution;
        TrialResult result;
        result.fits = false;
        auto const placement = droppedAtRandom(level, solution, part, random);
        if (placement && whyItSticksOut(level.level(), level.data().parts, *placement)) {
            result.fits = true; // the player's try is refused
        } else if (placement) {
            solution.placements.push_back(*placement);
            result = tryOut(level, solution, {.frames = frames});
        }
        return toText(result);
    });
    for (std::size_t index = 0; index < results.size(); ++index) {
        if (results[index]) {
            TrialResult const result = trialFrom(*results[index]);
            Drop& drop = drops[index / each];
            if (result.fits) {
                drop.ends.push_back({result.solved, result.frame});
                ++drop.runs;
                drop.solved += result.solved ? 1 : 0;
            }
        }
    }
    return drops;
}

} // namespace trembler::insight
