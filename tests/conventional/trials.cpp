#include "tests/conventional/trials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trembler::conventional {
namespace {

Trial run(Scene const& scene, Stage const& stage, Setting const& setting) {
    Trial trial;
    trial.kinds = setting.kinds;
    Stage::Watch const watch = scene.watch();
    Film const bodies = stage.play(setting, Kind::bodies, watch);
    trial.right = scene.right(setting, stage.factsOf(setting), bodies);
    trial.physical = scene.outcome(stage.play(setting, Kind::physical, watch), false);
    for (Effort const& effort : scene.efforts()) {
        trial.scripted.push_back(
            scene.outcome(stage.play(setting, Kind::conventional, watch, effort.scripts(setting)), true));
    }
    return trial;
}

/// The share of `answer` in the trials for which `picks` is true.
template <class Picks, class Answer>
Share shareOf(SceneResult const& result, Picks const& picks, Answer const& answer) {
    Share share;
    for (Trial const& trial : result.trials) {
        if (picks(trial)) {
            ++share.all;
            share.of += answer(trial) == trial.right ? 1U : 0U;
        }
    }
    return share;
}

double wilson(Share share, double sign) {
    if (share.all == 0) {
        return 0;
    }
    constexpr double z = 1.959963984540054; // 97.5 % of a normal distribution lie below
    auto const n = static_cast<double>(share.all);
    double const p = static_cast<double>(share.of) / n;
    double const middle = p + z * z / (2 * n);
    double const half = z * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n));
    return (middle + sign * half) / (1 + z * z / n);
}

} // namespace

double Share::low() const {
    return wilson(*this, -1);
}
double Share::high() const {
    return wilson(*this, 1);
}

std::string toText(Share share) {
    return fmt::format("{} of {} ({:.0f}–{:.0f} %)", share.of, share.all, 100 * share.low(),
                       100 * share.high());
}

Trial runTrial(Scene const& scene, Stage const& stage, std::uint64_t number) {
    Trial trial = run(scene, stage, perturbed(scene, stage, number));
    trial.number = number;
    return trial;
}

Trial runDescribed(Scene const& scene, Stage const& stage) {
    return run(scene, stage, scene.asDescribed(stage));
}

SceneResult runTrials(Scene const& scene, Stage const& stage, std::uint64_t count) {
    SceneResult result{.title = scene.title(), .efforts = {}, .scripts = {}, .trials = {}};
    Setting const described = scene.asDescribed(stage);
    for (Effort const& effort : scene.efforts()) {
        result.efforts.push_back(effort.title);
        result.scripts.push_back(effort.scripts(described).size());
    }
    for (std::uint64_t number = 1; number <= count; ++number) {
        result.trials.push_back(runTrial(scene, stage, number));
    }
    return result;
}

std::string shareTable(std::vector<SceneResult> const& results) {
    std::string table =
        "| scene | how | scripts | right | right where the other is, too |\n|---|---|--:|---|---|\n";
    auto const every = [](Trial const&) { return true; };
    for (SceneResult const& result : results) {
        table += fmt::format("| **{}** | Trembler | 0 | {} | |\n", result.title,
                             toText(shareOf(result, every, [](Trial const& t) { return t.physical; })));
        for (std::size_t effort = 0; effort < result.efforts.size(); ++effort) {
            auto const scripted = [&](Trial const& t) { return t.scripted[effort]; };
            std::size_t both = 0;
            for (Trial const& trial : result.trials) {
                both += trial.physical == trial.right && trial.scripted[effort] == trial.right ? 1U : 0U;
            }
            table += fmt::format("| | scripts {} | {} | {} | both: {} |\n", result.efforts[effort],
                                 result.scripts[effort], toText(shareOf(result, every, scripted)),
                                 toText({both, result.trials.size()}));
        }
    }
    return table;
}

std::string kindTable(SceneResult const& result) {
    std::string table = fmt::format("| {} | Trembler |", result.title);
    std::string line = "|---|--:|";
    for (std::size_t effort = 0; effort < result.efforts.size(); ++effort) {
        table += fmt::format(" {} scripts |", result.scripts[effort]);
        line += "--:|";
    }
    table += "\n" + line + "\n";
    std::set<std::string> kinds;
    for (Trial const& trial : result.trials) {
        kinds.insert(trial.kinds.begin(), trial.kinds.end());
    }
    for (std::string const& kind : kinds) {
        auto const has = [&](Trial const& trial) {
            return std::find(trial.kinds.begin(), trial.kinds.end(), kind) != trial.kinds.end();
        };
        Share const physical = shareOf(result, has, [](Trial const& t) { return t.physical; });
        table += fmt::format("| {} | {} of {} |", kind, physical.of, physical.all);
        for (std::size_t effort = 0; effort < result.efforts.size(); ++effort) {
            Share const scripted = shareOf(result, has, [&](Trial const& t) { return t.scripted[effort]; });
            table += fmt::format(" {} |", scripted.of);
        }
        table += "\n";
    }
    return table;
}

std::string missTable(std::vector<SceneResult> const& results) {
    std::string table = "| scene | number | perturbed by | should be | Trembler |\n|---|--:|---|---|---|\n";
    for (SceneResult const& result : results) {
        for (Trial const& trial : result.trials) {
            if (trial.physical != trial.right) {
                table += fmt::format("| {} | {} | {} | {} | {} |\n", result.title, trial.number,
                                     fmt::join(trial.kinds, "; "), trial.right, trial.physical);
            }
        }
    }
    return table;
}

std::string firstTable(std::vector<SceneResult> const& results, std::size_t count) {
    std::string table =
        "| scene | number | perturbed by | should be | Trembler | scripts |\n|---|--:|---|---|---|---|\n";
    for (SceneResult const& result : results) {
        for (std::size_t i = 0; i < std::min(count, result.trials.size()); ++i) {
            Trial const& trial = result.trials[i];
            std::string scripted;
            for (std::string const& outcome : trial.scripted) {
                scripted +=
                    (scripted.empty() ? "" : ", ") + std::string(outcome == trial.right ? "right" : "wrong");
            }
            table += fmt::format("| {} | {} | {} | {} | {} | {} |\n", result.title, trial.number,
                                 fmt::join(trial.kinds, "; "), trial.right,
                                 trial.physical == trial.right ? "right" : "wrong", scripted);
        }
    }
    return table;
}

} // namespace trembler::conventional
