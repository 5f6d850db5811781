#include "insight/report/level_report.hpp"

#include "insight/trial/solution_text.hpp"
#include "insight/trial/trial.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace trembler::insight {
namespace {

constexpr std::uint64_t handsOffWait = 3600; // frames, as `trembler verify` waits
constexpr std::uint64_t dropFrames = 1800;
constexpr double robustEnough = 0.9;
constexpr double luckyEnough = 0.05;

class Reporter {
public:
    Reporter(LevelUnderTest const& level, ReportOptions const& options, Workers& workers)
        : level_(level), options_(options), workers_(workers), runs_(level.data(), level.level()) {}

    LevelReport make() {
        report_.level = level_.name();
        report_.title = level_.level().title;
        report_.seed = options_.robustness.seed;
        report_.jitter = options_.robustness.jitter;
        report_.demonstration = level_.level().demonstration;
        say("what its solutions need");
        examineSolutions();
        say("how exact its solutions must be");
        displaceSolutions();
        say("single parts dropped at random");
        report_.drops = randomDrops(level_, options_.drops, dropFrames, options_.robustness.seed, workers_);
        if (options_.costs) {
            say("what its effects cost");
            report_.ways = waysToCompute(level_, workers_);
            report_.costs = effectCosts(level_, representative());
        }
        if (options_.search > 0) {
            say("what else solves it");
            search();
        }
        report_.complete = !workers_.stopped();
        return std::move(report_);
    }

private:
    void say(std::string const& what) const {
        if (options_.step) {
            options_.step(what);
        }
    }

    /// The first solution that solves it, else a run hands off.
    [[nodiscard]] Solution representative() const {
        for (Solution const& solution : level_.level().solutions) {
            if (solution.solves) {
                return solution;
            }
        }
        return {};
    }

    void examineSolutions() {
        std::vector<Solution> const& solutions = level_.level().solutions;
        std::vector<std::string> keys{fmt::format("hands-off/{}", level_.identity())};
        for (Solution const& solution : solutions) {
            keys.push_back(fmt::format("recorded/{}/{}", level_.identity(), solution.name));
        }
        auto const results = workers_.share(keys, [&](std::size_t index) {
            if (index == 0) {
                return toText(tryOut(level_, {}, {.frames = handsOffWait, .mustFit = false}));
            }
            Solution const& solution = solutions[index - 1];
            Needs const needs = needsOf(runs_, solution, framesOf(solution));
            CauseGraph graph;
            if (needs.solves) {
                graph = causeGraphOf(runs_, needs.least, framesOf(solution));
            }
            return nlohmann::json{toText(needs), toText(graph)}.dump();
        });
        if (results[0]) {
            report_.emptyToolboxSolves = trialFrom(*results[0]).solved;
        }
        for (std::size_t i = 0; i < solutions.size(); ++i) {
            if (!results[i + 1]) {
                continue;
            }
            nlohmann::json const told = nlohmann::json::parse(*results[i + 1]);
            SolutionReport one;
            one.name = solutions[i].name;
            one.expected = solutions[i].solves;
            one.needs = needsFrom(told.at(0).get<std::string>(), solutions[i]);
            one.graph = causeGraphFrom(told.at(1).get<std::string>());
            report_.solutions.push_back(std::move(one));
        }
        numberKinds();
    }

    void numberKinds() {
        std::vector<SolutionReport>& all = report_.solutions;
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (!all[i].needs.solves) {
                continue;
            }
            auto const same = std::find_if(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(i),
                                           [&](SolutionReport const& other) {
                                               return other.kind != 0 && !differ(other.graph, all[i].graph);
                                           });
            all[i].kind = same == all.begin() + static_cast<std::ptrdiff_t>(i) ? ++report_.kinds : same->kind;
        }
    }

    void displaceSolutions() {
        std::vector<SolvedBy> solved;
        std::vector<SolutionReport*> reports;
        for (SolutionReport& one : report_.solutions) {
            if (one.needs.solves) {
                solved.push_back({level_.level().findSolution(one.name), one.needs.frame});
                reports.push_back(&one);
            }
        }
        auto const robustness = robustnessOf(level_, solved, options_.robustness, workers_);
        for (std::size_t i = 0; i < reports.size(); ++i) {
            reports[i]->robustness = robustness[i];
        }
        if (options_.maps) {
            auto maps = placeMapsOf(level_, solved, options_.mapStep, options_.mapReach, workers_);
            for (std::size_t i = 0; i < reports.size(); ++i) {
                reports[i]->maps = std::move(maps[i]);
            }
        }
    }

    void search() {
        SearchOptions options;
        options.runs = options_.search;
        options.seed = options_.robustness.seed;
        report_.search = searchFor(level_, options, workers_);
        for (FoundSolution const& found : report_.search->found) {
            auto const same = std::find_if(
                report_.solutions.begin(), report_.solutions.end(), [&](SolutionReport const& recorded) {
                    return recorded.needs.solves && !differ(recorded.graph, found.graph);
                });
            report_.foundAs.push_back(same == report_.solutions.end() ? "" : same->name);
        }
    }

    LevelUnderTest const& level_;
    ReportOptions const& options_;
    Workers& workers_;
    LevelRuns runs_;
    LevelReport report_;
};

} // namespace

LevelReport reportOn(LevelUnderTest const& level, ReportOptions const& options, Workers& workers) {
    return Reporter(level, options, workers).make();
}

std::vector<std::string> shortcomings(LevelReport const& report) {
    std::vector<std::string> faults;
    if (report.demonstration) {
        return faults;
    }
    if (report.emptyToolboxSolves) {
        faults.emplace_back("an empty toolbox solves it");
    }
    if (report.kinds < 2) {
        faults.push_back(fmt::format("its recorded solutions are of {} kind{}, not of 2", report.kinds,
                                     report.kinds == 1 ? "" : "s"));
    }
    for (SolutionReport const& solution : report.solutions) {
        if (solution.expected && !solution.needs.solves) {
            faults.push_back(fmt::format("'{}' does not solve it", solution.name));
        } else if (solution.expected && solution.robustness.runs > 0 &&
                   solution.robustness.share() < robustEnough) {
            faults.push_back(fmt::format("'{}' succeeds in only {:.0f} % of its displaced runs",
                                         solution.name, 100 * solution.robustness.share()));
        }
    }
    for (Drop const& drop : report.drops) {
        if (drop.share() > luckyEnough) {
            faults.push_back(fmt::format("{}, dropped at random, solves it in {:.0f} % of tries", drop.part,
                                         100 * drop.share()));
        }
    }
    return faults;
}

} // namespace trembler::insight
