#include "insight/search/recorded.hpp"

#include "insight/trial/solution_text.hpp"
#include "insight/trial/trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace trembler::insight {
namespace {

constexpr std::uint64_t framesAfter = 60; // shown after the level is solved

} // namespace

std::vector<RecordedKind> recordedKinds(LevelUnderTest const& level, Workers& workers) {
    LevelRuns const runs(level.data(), level.level());
    std::vector<Solution> const& solutions = level.level().solutions;
    std::vector<std::string> keys;
    for (Solution const& solution : solutions) {
        keys.push_back(
            fmt::format("recorded kind/{}/{}/{}", level.identity(), identityOf(solution), solution.name));
    }
    auto const results = workers.share(keys, [&](std::size_t index) {
        Solution const& solution = solutions[index];
        Needs const needs = needsOf(runs, solution, framesOf(solution), EffectsToo::no);
        return toText(needs.solves ? causeGraphOf(runs, needs.least, framesOf(solution)) : CauseGraph());
    });
    std::vector<RecordedKind> kinds;
    for (std::size_t i = 0; i < solutions.size(); ++i) {
        if (CauseGraph graph = results[i] ? causeGraphFrom(*results[i]) : CauseGraph(); graph.solves) {
            kinds.push_back({solutions[i].name, std::move(graph)});
        }
    }
    return kinds;
}

std::string recordedAs(std::vector<RecordedKind> const& recorded, FoundSolution const& found) {
    auto const same = std::find_if(recorded.begin(), recorded.end(),
                                   [&](RecordedKind const& one) { return !differ(one.graph, found.graph); });
    return same == recorded.end() ? std::string() : same->name;
}

Solution keptSolution(FoundSolution const& found, std::size_t number) {
    Solution solution = found.needs.least;
    std::vector<std::string> makings = found.needs.parts;
    makings.insert(makings.end(), found.needs.deeds.begin(), found.needs.deeds.end());
    solution.name = fmt::format("found {}", number);
    char const* before = ": ";
    for (std::string const& making : makings) { // a name is at most 100 bytes, and another number may follow
        if (solution.name.size() + making.size() > 80) {
            solution.name += "...";
            break;
        }
        solution.name += before + making;
        before = ", ";
    }
    solution.frames = static_cast<int>(found.needs.leastFrame + framesAfter);
    return solution;
}

Solution solutionForFile(GameData const& data, LevelFile const& file, FoundSolution const& found,
                         std::size_t number) {
    Solution solution = keptSolution(found, number);
    if (file.demonstration && !file.task.is_null() && !file.goals.is_null()) {
        LevelRuns const asItIs(data, file);
        solution.solves = asItIs.run({solution, {}}, {.frames = framesOf(solution)}).solved;
    }
    return solution;
}

} // namespace trembler::insight
