#include "insight/search/search.hpp"

#include "insight/search/mutation.hpp"
#include "insight/search/random_placement.hpp"
#include "insight/trial/solution_text.hpp"
#include "insight/trial/text_hash.hpp"
#include "insight/trial/trial.hpp"
#include "runtime/level/json/diagnostic.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace trembler::insight {
namespace {

// Trials of a generation: a quarter of those before, so that the first nearest misses are used early.
constexpr std::uint64_t leastGeneration = 16;
constexpr std::uint64_t mostGeneration = 64;
constexpr double byChance = 0.3;  // of the attempts of a generation: the measure may mislead
constexpr double combined = 0.35; // several parts at once, see Mutator::combined()
constexpr std::size_t mostParents = 40;
constexpr std::size_t mostAlike = 5;      // parents with the same parts and deeds
constexpr double barrenCost = 0.02;       // added to the miss of a parent for each change without success
constexpr double farther = 0.3;           // added to the miss of attempts with the parts of a known solution
constexpr std::uint64_t mostExamined = 2; // solutions with the same parts and deeds

using MultiSet = std::multiset<std::string>;

/// The parts and deeds of an attempt, whatever their places.
MultiSet makingsOf(Solution const& solution) {
    MultiSet makings;
    for (Placement const& placement : solution.placements) {
        makings.insert(placement.part);
    }
    for (Deed const& deed : deedsOf(solution)) {
        makings.insert(deed.what);
    }
    for (LevelConnection const& wire : solution.wires) {
        makings.insert("wire " + wire.a + ", " + wire.b);
    }
    return makings;
}

bool includesAll(MultiSet const& many, MultiSet const& few) {
    return std::includes(many.begin(), many.end(), few.begin(), few.end());
}

class Search {
public:
    Search(LevelUnderTest const& level, SearchOptions const& options, Workers& workers)
        : level_(level), options_(options), workers_(workers), runs_(level.data(), level.level()),
          mutator_(level, options.hands) {}

    SearchResult run() {
        result_.places = mutator_.places().size();
        if (options_.random) {
            while (mayGoOn()) {
                tryGeneration("random", [&](CounterRandom& random) {
                    return Attempt{randomSolution(level_, random), 0};
                });
            }
            return std::move(result_);
        }
        trySolutions({Solution{}}, "empty");
        while (mayGoOn()) {
            std::vector<Parent> const parents = parents_;
            std::string text;
            for (Parent const& parent : parents) {
                text += identityOf(parent.solution);
            }
            bool const begins = result_.runs < leastGeneration;
            tryGeneration("mutation/" + hashOf(text), [&](CounterRandom& random) {
                double const which = random.unit() * (begins ? byChance + combined : 1);
                return which < byChance              ? Attempt{randomSolution(level_, random), 0}
                       : which < byChance + combined ? Attempt{mutator_.combined(random), 0}
                                                     : mutator_.changed(parents, tried_, random);
            });
        }
        return std::move(result_);
    }

private:
    [[nodiscard]] bool mayGoOn() const { return result_.runs < options_.runs && !workers_.stopped(); }

    /// Trials of attempts that the pieces of work make themselves, as making one takes a while, too.
    void tryGeneration(std::string const& what, std::function<Attempt(CounterRandom&)> const& make) {
        std::uint64_t const wanted = std::clamp(result_.runs / 4, leastGeneration, mostGeneration);
        std::size_t const count = std::min(wanted, options_.runs - result_.runs);
        std::vector<std::string> keys;
        for (std::size_t i = 0; i < count; ++i) {
            keys.push_back(fmt::format("search/{}/{}/{}/{}/{}/{}", level_.identity(), options_.seed,
                                       options_.frames, options_.hands, what, result_.runs + i + 1));
        }
        std::uint64_t const first = result_.runs + 1;
        take(workers_.share(keys, [&](std::size_t index) {
            CounterRandom random(keyOf(options_.seed,
                                       {"search", options_.random ? "random" : "mutation", level_.identity()},
                                       first + index));
            return trial(make(random));
        }));
    }

    void trySolutions(std::vector<Solution> const& solutions, std::string const& what) {
        std::vector<std::string> keys;
        for (std::size_t i = 0; i < solutions.size(); ++i) {
            keys.push_back(fmt::format("search/{}/{}/{}/{}/{}", level_.identity(), options_.frames, what,
                                       identityOf(solutions[i]), result_.runs + i + 1));
        }
        take(workers_.share(keys, [&](std::size_t index) { return trial({solutions[index], 0}); }));
    }

    [[nodiscard]] std::string trial(Attempt const& attempt) const {
        TrialResult result;
        try {
            result = tryOut(level_, attempt.solution,
                            {.frames = options_.frames, .measureMiss = !options_.random});
        } catch (InputError const&) { // for example a wire to something that no longer exists
            result.fits = false;
        }
        return nlohmann::json{toText(attempt.solution), toText(result), attempt.parent}.dump();
    }

    void take(std::vector<std::optional<std::string>> const& results) {
        std::vector<std::pair<std::uint64_t, Solution>> solving;
        for (auto const& text : results) {
            if (!text) {
                continue;
            }
            nlohmann::json const parsed = nlohmann::json::parse(*text);
            Solution const solution = solutionFrom(parsed.at(0).get<std::string>());
            TrialResult const result = trialFrom(parsed.at(1).get<std::string>());
            ++result_.runs;
            tried_.insert(identityOf(solution));
            noteChild(parsed.at(2).get<std::uint64_t>(), result);
            if (result.solved) {
                ++result_.solved;
                result_.firstSolved = result_.firstSolved.value_or(result_.runs);
                solving.emplace_back(result_.runs, solution);
            } else if (result.fits) {
                parents_.push_back({solution, result.miss, result_.runs});
                if (result.miss < result_.nearest) {
                    result_.nearest = result.miss;
                    result_.nearestMiss = solution;
                }
            }
        }
        examine(solving);
        chooseParents();
        if (options_.progress) {
            options_.progress(result_.runs, result_.found.size());
        }
        if (options_.sofar) {
            options_.sofar(result_);
        }
    }

    /// Counts the changes of a parent that came no nearer than the parent itself.
    void noteChild(std::uint64_t run, TrialResult const& result) {
        auto const parent =
            std::find_if(parents_.begin(), parents_.end(), [&](Parent const& one) { return one.run == run; });
        if (run > 0 && parent != parents_.end() && !result.solved && result.miss >= parent->miss) {
            ++barren_[run];
        }
    }

    /// Reduces solutions to what they need, and keeps those of new kinds.
    void examine(std::vector<std::pair<std::uint64_t, Solution>> const& solving) {
        std::vector<std::pair<std::uint64_t, Solution>> chosen;
        for (auto const& [run, solution] : solving) {
            std::uint64_t& times = solvedWith_[makingsOf(solution)];
            if (++times <= mostExamined) {
                chosen.emplace_back(run, solution);
            }
        }
        std::vector<std::string> keys;
        for (auto const& [run, solution] : chosen) {
            keys.push_back(fmt::format("needs/{}/{}/{}/{}", level_.identity(), options_.frames, run,
                                       identityOf(solution)));
        }
        auto const examined = workers_.share(keys, [&](std::size_t index) {
            Solution const& solution = chosen[index].second;
            Needs const needs = needsOf(runs_, solution, options_.frames);
            CauseGraph const graph =
                causeGraphOf(runs_, needs.solves ? needs.least : solution, options_.frames);
            return nlohmann::json{toText(needs), toText(graph)}.dump();
        });
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            if (examined[i]) {
                nlohmann::json const parsed = nlohmann::json::parse(*examined[i]);
                keep({needsFrom(parsed.at(0).get<std::string>(), chosen[i].second),
                      causeGraphFrom(parsed.at(1).get<std::string>()), chosen[i].first, 0});
            }
        }
        for (FoundSolution& found : result_.found) {
            MultiSet const least = makingsOf(found.needs.least);
            found.times = 0;
            for (auto const& [makings, times] : solvedWith_) {
                found.times += includesAll(makings, least) ? times : 0;
            }
        }
    }

    void keep(FoundSolution found) {
        bool const known =
            std::any_of(result_.found.begin(), result_.found.end(),
                        [&](FoundSolution const& other) { return !differ(other.graph, found.graph); });
        if (found.needs.solves && !known) {
            result_.found.push_back(std::move(found));
        }
    }

    void chooseParents() {
        std::vector<MultiSet> known;
        for (FoundSolution const& found : result_.found) {
            known.push_back(makingsOf(found.needs.least));
        }
        struct Ranked {
            double miss;
            std::size_t size;
            MultiSet makings;
            Parent parent;
        };
        std::vector<Ranked> ranked;
        for (Parent& parent : parents_) {
            MultiSet makings = makingsOf(parent.solution);
            bool const knownParts = std::any_of(known.begin(), known.end(), [&](MultiSet const& few) {
                return !few.empty() && includesAll(makings, few);
            });
            auto const barren = barren_.find(parent.run);
            double const cost =
                barren == barren_.end() ? 0 : barrenCost * static_cast<double>(barren->second);
            ranked.push_back({parent.miss + cost + (knownParts ? farther : 0), makings.size(), makings,
                              std::move(parent)});
        }
        std::sort(ranked.begin(), ranked.end(), [](Ranked const& a, Ranked const& b) {
            return std::tie(a.miss, a.size, a.parent.run) < std::tie(b.miss, b.size, b.parent.run);
        });
        parents_.clear();
        std::map<MultiSet, std::size_t> alike;
        for (Ranked& one : ranked) {
            if (parents_.size() < mostParents && ++alike[one.makings] <= mostAlike) {
                parents_.push_back(std::move(one.parent));
            }
        }
        if (parents_.empty()) {
            parents_.push_back({}); // everything solves it: begin with nothing
        }
    }

    LevelUnderTest const& level_;
    SearchOptions const& options_;
    Workers& workers_;
    LevelRuns runs_;
    Mutator mutator_;
    std::vector<Parent> parents_; // the nearest first
    Tried tried_;
    std::map<std::uint64_t, std::uint64_t> barren_; // by Parent::run
    std::map<MultiSet, std::uint64_t> solvedWith_;
    SearchResult result_;
};

} // namespace

SearchResult searchFor(LevelUnderTest const& level, SearchOptions const& options, Workers& workers) {
    return Search(level, options, workers).run();
}

} // namespace trembler::insight
