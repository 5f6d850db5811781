// Commands on the single entries of recorded solutions: placements, wires, inputs, changes of accuracy.
#pragma once

#include "puzzle/edit/document/command.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace trembler::edit {

// A solution is referred to by its name, a list by its key in files ("inputs"), an entry by its index in the
// file's list. What does not exist throws CommandError, and so does an entry that is neither an object nor a
// list. What an entry means is checked by the list of problems.

[[nodiscard]] Command addSolutionEntry(Json const& level, std::string const& solution,
                                       std::string const& list, Json const& entry);
/// Placed objects are called after their part and numbered by their places, so a changed placement may change
/// the names of others: wires and inputs keep referring to the same objects.
[[nodiscard]] Command setSolutionEntry(Json const& level, std::string const& solution,
                                       std::string const& list, std::size_t index, Json const& entry);
/// Removes a placement with the wires and inputs that name its object.
[[nodiscard]] Command removeSolutionEntry(Json const& level, std::string const& solution,
                                          std::string const& list, std::size_t index);
[[nodiscard]] Command moveSolutionEntry(Json const& level, std::string const& solution,
                                        std::string const& list, std::size_t from, std::size_t to);

/// The names of the objects that a solution's placements become, in the order of the file; empty for entries
/// that are no placements. Throws CommandError if there is no such solution.
[[nodiscard]] std::vector<std::string> placedNames(Json const& level, std::string const& solution);

} // namespace trembler::edit
