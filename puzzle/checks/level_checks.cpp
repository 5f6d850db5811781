#include "puzzle/checks/level_checks.hpp"

#include "puzzle/checks/checked_level.hpp"
#include "runtime/level/build/placing.hpp"
#include "runtime/level/json/add_problem.hpp"
#include "runtime/level/read/read_level.hpp"

#include <exception>

namespace trembler {
namespace {

void complainAboutLacking(LevelFile const& level, std::vector<Diagnostic>& lacking) {
    if (level.goals.is_null()) {
        lacking.push_back(level.diagnostic("/goals", "it has no goals", ""));
    }
    if (level.solutions.empty()) {
        lacking.push_back(level.diagnostic("/solutions", "no solution is recorded", ""));
    }
}

/// Complains about placements of recorded solutions that the level does not allow, in the words with which
/// the solution would be refused.
void complainAboutPlacements(GameData const& data, LevelFile const& level, Problems& problems) {
    for (Solution const& solution : level.solutions) {
        PlacementCount count(level, data.parts);
        for (std::size_t const index : canonicalOrder(solution.placements)) {
            Placement const& placement = solution.placements[index];
            if (auto const refusal = count.add(placement)) {
                addProblem(problems, [&] {
                    return level.diagnostic(placement.path, *refusal, "a placement that the level allows");
                });
            }
        }
    }
}

} // namespace

LevelCheckup checkWholeLevel(GameData const& data, std::shared_ptr<JsonDocument const> const& document,
                             std::map<std::string, std::string> const& detail) {
    LevelCheckup checkup;
    try {
        LevelFile level = readLevel(data.registry, document);
        checkup.read = true;
        complainAboutLacking(level, checkup.lacking);
        for (auto const& [effect, name] : detail) {
            level.detail[effect] = name;
        }
        BuiltLevel const built = checkPlayable(data.registry, data.parts, level);
        checkup.playable = true;
        Problems problems;
        complainAboutPlacements(data, level, problems);
        complainAboutReach(data, level, *built.world, problems);
        complainAboutHopeless(data, level, *built.world, problems);
        complainAboutMatter(data.parts, level, built, problems);
        checkup.crowded = complainAboutCrowds(level, *built.world, problems);
        problems.throwIfAny();
    } catch (InputError const& error) {
        checkup.problems = error.diagnostics();
    } catch (std::exception const& error) { // a component that refuses the scene in words of its own
        checkup.problems.push_back(document->diagnostic("", error.what(), ""));
    }
    return checkup;
}

} // namespace trembler
