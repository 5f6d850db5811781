// The differences between solutions of one level, apart from the places of their parts.
#pragma once

#include "runtime/level/model/level.hpp"
#include "runtime/level/model/part_library.hpp"
#include "runtime/world/registry.hpp"

#include <cstdint>
#include <set>
#include <string>

namespace trembler {

/// The kind of a solution: which parts were placed, the player's deeds while it ran, and which components
/// caused the goals. Places and numbers of parts, and times, do not belong to the kind.
struct SolutionKind {
    std::set<std::string> parts;   ///< names of the part definitions that were placed
    std::set<std::string> actions; ///< of the player in the run: "grab", "cut", "remove"
    /// Names of the components among the direct and indirect causes of the goals, see
    /// GoalJudge::causes() and Tracer::chain(): "Electricity <- Dynamics".
    std::set<std::string> causes;

    bool operator==(SolutionKind const&) const = default;
};

/// Runs the solution from its beginning in a traced world of its own, until it solves the level or `most`
/// frames have passed, and returns its kind. A pure function of its arguments, for any number of threads;
/// takes as long as the run. `solves` is whether the level was solved. Throws InputError if the solution
/// does not fit.
struct KindOfRun {
    SolutionKind kind;
    bool solves = false;
};
[[nodiscard]] KindOfRun kindOf(Registry const& registry, PartLibrary const& parts, LevelFile const& level,
                               Solution const& solution, std::uint64_t most);

/// Whether the two are solutions of different kinds. A solution whose parts are those of the other and some
/// more, with the same actions and causes, is the same kind: a part that was merely added solves nothing.
[[nodiscard]] bool differInKind(SolutionKind const& a, SolutionKind const& b);

} // namespace trembler
