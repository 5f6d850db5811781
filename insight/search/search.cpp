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

constexpr std::size_t generation = 64; // trials
constexpr double byChance = 0.25;      // of the attempts of a generation: the measure may mislead
constexpr std::size_t mostParents = 40;
constexpr std::size_t mostAlike = 5;      // parents with the same parts and deeds
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

struct Tried {
    Solution solution;
    TrialResult result;
};

class Search {
public:
    Search(LevelUnderTest const& level, SearchOptions const& options, Workers& workers)
        : level_(level), options_(options), workers_(workers), runs_(level.data(), level.level()),
          mutator_(level, options.hands) {}

    SearchResult run() {
        result_.places = mutator_.places().size();
        if (options_.random) {
            while (mayGoOn()) {
                tryGeneration("random",
                              [&](CounterRandom& random) { return randomSolution(level_, random); });
            }
            return std::move(result_);
        }
        trySolutions({Solution{}}, "empty");
        std::vector<Solution> const singles = singleParts();
        std::size_t const most = std::min<std::size_t>(singles.size(), options_.runs / 3);
        for (std::size_t begin = 0; begin < most && mayGoOn(); begin += generation) {
            std::vector<Solution> batch;
            for (std::size_t i = begin; i < std::min(most, begin + generation); ++i) {
                batch.push_back(singles[i]);
            }
            trySolutions(batch, "single");
        }
        while (mayGoOn()) {
            std::vector<Parent> const parents = parents_;
            std::string text;
            for (Parent const& parent : parents) {
                text += identityOf(parent.solution);
            }
            tryGeneration("mutation/" + hashOf(text), [&](CounterRandom& random) {
                return random.chance(byChance) ? randomSolution(level_, random)
                                               : mutator_.changed(parents, random);
            });
        }
        return std::move(result_);
    }

private:
    [[nodiscard]] bool mayGoOn() const { return result_.runs < options_.runs && !workers_.stopped(); }

    /// Every part in every place, as it is and upright: place by place in turns of all kinds of places, so
    /// that the first ones are of all kinds.
    [[nodiscard]] std::vector<Solution> singleParts() const {
        std::map<Place::Kind, std::vector<Place const*>> byKind;
        std::size_t longest = 0;
        for (Place const& place : mutator_.places()) {
            byKind[place.kind].push_back(&place);
            longest = std::max(longest, byKind[place.kind].size());
        }
        std::vector<Solution> singles;
        for (double const turn : {0.0, pi / 2}) {
            for (std::size_t i = 0; i < longest; ++i) {
                for (auto const& [kind, places] : byKind) {
                    if (i >= places.size()) {
                        continue;
                    }
                    for (ToolboxEntry const& entry : level_.level().toolbox) {
                        if (auto const placement = placedAt(level_, *places[i], entry.part, turn)) {
                            Solution solution;
                            solution.placements.push_back(*placement);
                            singles.push_back(std::move(solution));
                        }
                    }
                }
            }
        }
        return singles;
    }

    /// Trials of attempts that the pieces of work make themselves, as making one takes a while, too.
    void tryGeneration(std::string const& what, std::function<Solution(CounterRandom&)> const& make) {
        std::size_t const count = std::min<std::uint64_t>(generation, options_.runs - result_.runs);
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
        take(workers_.share(keys, [&](std::size_t index) { return trial(solutions[index]); }));
    }

    [[nodiscard]] std::string trial(Solution const& solution) const {
        TrialResult result;
        try {
            result = tryOut(level_, solution, {.frames = options_.frames, .measureMiss = !options_.random});
        } catch (InputError const&) { // for example a wire to something that no longer exists
            result.fits = false;
        }
        return nlohmann::json{toText(solution), toText(result)}.dump();
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
            ranked.push_back(
                {parent.miss + (knownParts ? farther : 0), makings.size(), makings, std::move(parent)});
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
    std::map<MultiSet, std::uint64_t> solvedWith_;
    SearchResult result_;
};

} // namespace

SearchResult searchFor(LevelUnderTest const& level, SearchOptions const& options, Workers& workers) {
    return Search(level, options, workers).run();
}

} // namespace trembler::insight
