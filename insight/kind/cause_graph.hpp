// The kind of a solution as the graph of its causes.
#pragma once

#include "insight/run/level_runs.hpp"

#include <cstdint>
#include <set>
#include <string>
#include <utility>

namespace trembler::insight {

/// The way in which a level is solved, without places, numbers and times: which effects acted on which others
/// in the chain of causes of the goals, which parts the solution places, and what the player did in the run.
/// To be made of a solution without superfluous parts, see needsOf(): the chain may end before a part that is
/// needed.
struct CauseGraph {
    bool solves = false;         ///< else the rest is empty
    std::set<std::string> parts; ///< placed part definitions; "wire" if the player laid one
    std::set<std::string> deeds; ///< "grab", "cut", "remove"; those before the level was solved
    /// (cause, effect): titles of two different components, an event of the first is among the causes of an
    /// event of the second.
    std::set<std::pair<std::string, std::string>> links;

    friend bool operator==(CauseGraph const&, CauseGraph const&) = default;
};

/// Runs the solution in a traced world. A pure function of its arguments, for any number of threads.
[[nodiscard]] CauseGraph causeGraphOf(LevelRuns const& runs, Solution const& solution, std::uint64_t frames);

/// Whether two graphs are of different kinds: other links or deeds, or each has a part that the other has
/// not. A part that was merely added makes no other kind, as in differInKind().
[[nodiscard]] bool differ(CauseGraph const& a, CauseGraph const& b);

/// In words: "steel bar; Electricity <- Dynamics, Dynamics <- Magnetism": parts and deeds, then the
/// interactions among the causes, in alphabetical order.
[[nodiscard]] std::string inWords(CauseGraph const& graph);

[[nodiscard]] std::string toText(CauseGraph const& graph);
[[nodiscard]] CauseGraph causeGraphFrom(std::string const& text);

} // namespace trembler::insight
