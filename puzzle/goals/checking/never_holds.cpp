#include "puzzle/goals/checking/never_holds.hpp"

#include "puzzle/goals/checking/candidates.hpp"
#include "runtime/level/json/add_problem.hpp"

#include <fmt/format.h>

#include <utility>

namespace trembler {
namespace {

void complainIfNeverAmong(CandidateFinder const& candidates, Condition const& condition,
                          LevelFile const& level, Problems& problems) {
    if (auto why = condition.kind->whyNever(condition, candidates)) {
        addProblem(problems, [&] {
            return level.diagnostic(condition.path, fmt::format("can never hold: {}", why->message),
                                    std::move(why->expected));
        });
    }
    for (Condition const& child : condition.children) {
        complainIfNeverAmong(candidates, child, level, problems);
    }
}

} // namespace

void complainIfNever(Condition const& condition, LevelFile const& level, World const& world,
                     Problems& problems) {
    complainIfNeverAmong(CandidateFinder(level, world), condition, level, problems);
}

} // namespace trembler
