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
        report_.task = level_.isTask();
        report_.goals = goalsOf(level_);
        report_.complete = false;
        say("what its solutions need");
        examineSolutions();
        showSoFar();
        say("how exact its solutions must be");
        displaceSolutions();
        showSoFar();
        say("single parts dropped at random");
        report_.drops = randomDrops(level_, options_.drops, dropFrames, options_.robustness.seed, workers_);
        showSoFar();
        if (options_.chains) {
            say("why its solutions meet the goals");
            explainSolutions();
            showSoFar();
        }
        if (options_.maps) {
            say("where each part may lie");
            drawMaps();
            showSoFar();
        }
        if (options_.costs) {
            say("what its effects cost");
            LevelCosts measured = costsOf(level_, workers_);
            report_.ways = std::move(measured.ways);
            report_.costs = std::move(measured.costs);
            showSoFar();
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

    void showSoFar() const {
        if (options_.sofar) {
            options_.sofar(report_);
        }
    }

    void examineSolutions() {
        std::vector<Solution> const& solutions = level_.level().solutions;
        std::vector<std::string> keys{fmt::format("hands-off/{}", level_.identity())};
        for (Solution const& solution : solutions) {
            keys.push_back(fmt::format("recorded{}/{}/{}/{}", options_.effects ? "" : " without effects",
                                       level_.identity(), identityOf(solution), solution.name));
        }
        auto const results = workers_.share(keys, [&](std::size_t index) {
            if (index == 0) {
                return toText(tryOut(level_, {}, {.frames = handsOffWait, .mustFit = false}));
            }
            Solution const& solution = solutions[index - 1];
            Needs const needs = needsOf(runs_, solution, framesOf(solution),
                                        options_.effects ? EffectsToo::yes : EffectsToo::no);
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
            nlohmann::json const parsed = nlohmann::json::parse(*results[i + 1]);
            SolutionReport one;
            one.name = solutions[i].name;
            one.hasParts = !solutions[i].placements.empty();
            one.hasDeeds = !solutions[i].inputs.empty();
            one.needs = needsFrom(parsed.at(0).get<std::string>(), solutions[i]);
            one.expected = report_.task ? one.needs.solves : solutions[i].solves;
            one.graph = causeGraphFrom(parsed.at(1).get<std::string>());
            report_.solutions.push_back(std::move(one));
        }
        report_.examined = std::all_of(results.begin(), results.end(),
                                       [](std::optional<std::string> const& one) { return one.has_value(); });
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
        compareKinds();
    }

    void compareKinds() {
        std::vector<CauseGraph const*> graphs; // of the first solution of each kind
        for (SolutionReport const& one : report_.solutions) {
            if (one.kind == graphs.size() + 1) {
                graphs.push_back(&one.graph);
            }
        }
        for (std::size_t kind = 1; kind < graphs.size(); ++kind) {
            KindComparison nearest{kind + 1, 1, differenceOf(*graphs[kind], *graphs[0])};
            for (std::size_t with = 1; with < kind; ++with) {
                KindDifference difference = differenceOf(*graphs[kind], *graphs[with]);
                if (difference.size() < nearest.difference.size()) {
                    nearest = {kind + 1, with + 1, std::move(difference)};
                }
            }
            report_.comparisons.push_back(std::move(nearest));
        }
    }

    void explainSolutions() {
        std::vector<SolutionReport*> reports;
        std::vector<Solution const*> solutions;
        for (SolvedBy const& solved : solving(reports)) {
            solutions.push_back(solved.solution);
        }
        auto chains = chainsOf(level_, runs_, solutions, report_.goals, workers_);
        for (std::size_t i = 0; i < reports.size(); ++i) {
            reports[i]->chains = std::move(chains[i]);
        }
    }

    /// The solutions that solve the level, and their indices in the report.
    [[nodiscard]] std::vector<SolvedBy> solving(std::vector<SolutionReport*>& reports) {
        std::vector<SolvedBy> solved;
        for (SolutionReport& one : report_.solutions) {
            if (one.needs.solves) {
                solved.push_back({level_.level().findSolution(one.name), one.needs.frame});
                reports.push_back(&one);
            }
        }
        return solved;
    }

    void displaceSolutions() {
        std::vector<SolutionReport*> reports;
        auto const robustness = robustnessOf(level_, solving(reports), options_.robustness, workers_);
        for (std::size_t i = 0; i < reports.size(); ++i) {
            reports[i]->robustness = robustness[i];
        }
    }

    void drawMaps() {
        std::vector<SolutionReport*> reports;
        auto maps = placeMapsOf(level_, solving(reports), options_.map, workers_);
        for (std::size_t i = 0; i < reports.size(); ++i) {
            reports[i]->maps = std::move(maps[i]);
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

LevelCosts costsOf(LevelUnderTest const& level, Workers& workers) {
    LevelCosts measured;
    measured.ways = waysToCompute(level, workers);
    std::vector<Solution> const& solutions = level.level().solutions;
    std::size_t const run = measuredRun(level.level());
    measured.costs = effectCosts(level, run == solutions.size() ? Solution{} : solutions[run]);
    return measured;
}

std::vector<Shortcoming> shortcomingsOf(LevelReport const& report) {
    using Kind = Shortcoming::Kind;
    std::vector<Shortcoming> faults;
    if (report.demonstration) {
        return faults;
    }
    if (report.emptyToolboxSolves) {
        faults.push_back({Kind::solvesItself});
    }
    if ((report.examined || report.complete) && report.kinds < 2) { // otherwise they are not known yet
        faults.push_back({Kind::fewKinds, "", report.kinds});
    }
    for (SolutionReport const& solution : report.solutions) {
        Robustness const& robustness = solution.robustness;
        if (solution.expected && !solution.needs.solves) {
            faults.push_back({Kind::fails, solution.name});
        } else if (solution.expected && robustness.runs > 0 && robustness.share() < robustEnough) {
            faults.push_back({Kind::fragile, solution.name, 0, robustness.share()});
        }
    }
    for (Drop const& drop : report.drops) {
        if (drop.share() > luckyEnough) {
            faults.push_back({Kind::lucky, drop.part, 0, drop.share()});
        }
    }
    return faults;
}

std::vector<std::string> shortcomings(LevelReport const& report) {
    using Kind = Shortcoming::Kind;
    std::vector<std::string> faults;
    for (Shortcoming const& fault : shortcomingsOf(report)) {
        switch (fault.kind) {
        case Kind::solvesItself:
            faults.emplace_back("an empty toolbox solves it");
            break;
        case Kind::fewKinds:
            faults.push_back(fmt::format("its recorded solutions are of {} kind{}, not of 2", fault.kinds,
                                         fault.kinds == 1 ? "" : "s"));
            break;
        case Kind::fails:
            faults.push_back(fmt::format("'{}' does not solve it", fault.name));
            break;
        case Kind::fragile:
            faults.push_back(fmt::format("'{}' succeeds in only {:.0f} % of its displaced runs", fault.name,
                                         100 * fault.share));
            break;
        case Kind::lucky:
            faults.push_back(fmt::format("{}, dropped at random, solves it in {:.0f} % of tries", fault.name,
                                         100 * fault.share));
            break;
        }
    }
    return faults;
}

} // namespace trembler::insight
