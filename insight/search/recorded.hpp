// Compares the solutions that a search finds with those that a level's designer recorded.
#pragma once

#include "insight/search/search.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace trembler::insight {

/// A recorded solution without its superfluous entries, and its causes.
struct RecordedKind {
    std::string name;
    CauseGraph graph;
};

/// Of the recorded solutions that solve the level, in its order; of the solutions that were finished if the
/// workers are stopped. Throws InputError if one cannot be run.
[[nodiscard]] std::vector<RecordedKind> recordedKinds(LevelUnderTest const& level, Workers& workers);

/// The first recorded solution of the same kind; empty: there is none.
[[nodiscard]] std::string recordedAs(std::vector<RecordedKind> const& recorded, FoundSolution const& found);

/// A found solution as it is kept: with a name made of its parts and deeds, "found 2: steel bar", and as long
/// as it takes plus 1 s.
[[nodiscard]] Solution keptSolution(FoundSolution const& found, std::size_t number);

/// The same for the list of solutions in a level's file, given as it is read from there and not as it is
/// played: of a demonstration, whose task the solution fulfils, it is expected to reach the goals only if it
/// does. Runs the level once if it is one. Throws InputError if it cannot be read.
[[nodiscard]] Solution solutionForFile(GameData const& data, LevelFile const& file,
                                       FoundSolution const& found, std::size_t number);

} // namespace trembler::insight
