// Complains about goals that can never come true in the level as a whole: see level_checks.hpp.
#include "puzzle/checks/level_checks.hpp"
#include "puzzle/goals/checking/whole_level.hpp"
#include "puzzle/goals/read_goals.hpp"
#include "runtime/level/json/add_problem.hpp"

#include <fmt/format.h>

#include <utility>

namespace trembler {
namespace {

void complainIfHopeless(Condition const& condition, WholeLevel const& level, Problems& problems) {
    for (Impossibility& why : condition.kind->whyHopeless(condition, level)) {
        addProblem(problems, [&] {
            return level.level.diagnostic(why.path.empty() ? condition.path : std::move(why.path),
                                          fmt::format("can never hold: {}", why.message),
                                          std::move(why.expected));
        });
    }
    for (Condition const& child : condition.children) {
        complainIfHopeless(child, level, problems);
    }
}

} // namespace

void complainAboutHopeless(GameData const& data, LevelFile const& level, World const& world,
                           Problems& problems) {
    if (!level.mods.empty()) { // a mod's scripts may do anything
        return;
    }
    Problems ignored; // goals and task have been read before
    CandidateFinder const candidates(level, world);
    WholeLevel const whole{data.parts, level, world, candidates};
    for (auto const& condition : {readGoals(level, ignored), readTask(level, ignored)}) {
        if (condition) {
            complainIfHopeless(*condition, whole, problems);
        }
    }
}

} // namespace trembler
