// A report on a level for its designer: what its solutions need, how exact they must be, and which other
// solutions there are.
#pragma once

#include "insight/ablation/needs.hpp"
#include "insight/cost/accuracy_needed.hpp"
#include "insight/kind/cause_graph.hpp"
#include "insight/kind/kind_difference.hpp"
#include "insight/report/chains.hpp"
#include "insight/robustness/place_map.hpp"
#include "insight/robustness/robustness.hpp"
#include "insight/search/search.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace trembler::insight {

struct ReportOptions {
    RobustnessOptions robustness = {};
    int drops = 100;     ///< runs with each single part dropped at random
    bool effects = true; ///< which effects each solution needs
    bool chains = true;  ///< why each solution meets the goals
    bool maps = false;   ///< where each part may lie
    PlaceMapOptions map = {};
    bool costs = true;        ///< effects' times, and the cheapest ways to compute; not reproducible
    std::uint64_t search = 0; ///< trials in search of other solutions; 0: none
    /// Called with the name of each step of the work, for progress; may be empty.
    std::function<void(std::string const&)> step = {};
    /// Called after each part of the work with the report so far, for a caller that shows it as it comes; may
    /// be empty. Parts that are not known yet are empty, and robustness has no runs.
    std::function<void(struct LevelReport const&)> sofar = {};
};

struct SolutionReport {
    std::string name;
    /// Recorded as a solution, and not as a run that does not solve the level; of a task: it solves it.
    bool expected = true;
    bool hasParts = false; ///< the recorded run places some ...
    bool hasDeeds = false; ///< ... or has something done in it by hand
    Needs needs;
    CauseGraph graph;           ///< of `needs.least`
    std::size_t kind = 0;       ///< solutions of one kind have the same number, from 1; 0: it does not solve
    std::vector<Answer> chains; ///< for each goal, in the level's order, why the recorded run meets it
    Robustness robustness;
    std::vector<PlaceMap> maps;
};

/// How a kind of solutions differs from the one of those before it that differs least.
struct KindComparison {
    std::size_t kind = 2; ///< `here` in the difference
    std::size_t with = 1; ///< `there`
    KindDifference difference;
};

struct LevelReport {
    std::string level;
    std::string title;
    std::uint64_t seed = 1;
    Jitter jitter;
    bool demonstration = false; ///< it is meant to reach its goals by itself
    bool task = false;          ///< its goals are the task of a demonstration
    std::vector<ReportedGoal> goals;
    bool emptyToolboxSolves = false;
    std::vector<SolutionReport> solutions;
    std::size_t kinds = 0;
    std::vector<KindComparison> comparisons; ///< for each kind from the second on
    std::vector<Drop> drops;
    std::vector<EffectCost> costs;
    std::vector<WayToCompute> ways;
    std::optional<SearchResult> search;
    /// By index in search->found: the recorded solution of the same kind; empty: there is none.
    std::vector<std::string> foundAs;
    bool complete = true;  ///< false: the work was stopped before its end
    bool examined = false; ///< the empty toolbox and every recorded solution were run
};

/// Runs the level many times. Everything but the times depends on the level, the options and the program
/// only. Throws InputError if a recorded solution cannot be run.
[[nodiscard]] LevelReport reportOn(LevelUnderTest const& level, ReportOptions const& options,
                                   Workers& workers);

/// The costs of a level's effects, and the settings with which it may be computed.
struct LevelCosts {
    std::vector<EffectCost> costs; ///< of its first solution that solves it, else of a run hands off
    std::vector<WayToCompute> ways;
};
/// The costs without the rest of a report, as they take long. Throws as reportOn().
[[nodiscard]] LevelCosts costsOf(LevelUnderTest const& level, Workers& workers);

/// One reason why a puzzle falls short.
struct Shortcoming {
    enum class Kind : std::uint8_t {
        solvesItself, ///< an empty toolbox solves it
        fewKinds,     ///< its solutions are of `kinds` kinds
        fails,        ///< the recorded solution `name` does not solve it
        fragile,      ///< it succeeds in only a share of its displaced runs
        lucky         ///< the part `name`, dropped at random, solves it in that share of its runs
    };
    Kind kind = Kind::solvesItself;
    std::string name{};
    std::size_t kinds = 0;
    double share = 0; ///< 0 to 1
};
/// See shortcomings(). For an incomplete report: the reasons known so far.
[[nodiscard]] std::vector<Shortcoming> shortcomingsOf(LevelReport const& report);

/// Why a puzzle falls short of what is expected of one, in words; nothing expected of a demonstration: an
/// empty toolbox does not solve it, two recorded solutions differ in kind, each succeeds in 90 % of its
/// displaced runs, and no single part dropped at random solves it in more than 5 % of its runs.
[[nodiscard]] std::vector<std::string> shortcomings(LevelReport const& report);

} // namespace trembler::insight
