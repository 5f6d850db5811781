// Commands on the recorded solutions of a level.
#pragma once

#include "puzzle/edit/document/command.hpp"
#include "runtime/level/model/level.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace trembler::edit {

// A solution is referred to by its name; one that does not exist throws CommandError.

/// Its place in the file's list.
[[nodiscard]] std::size_t indexOfSolution(Json const& level, std::string const& name);
/// The keys of a solution in their usual order.
[[nodiscard]] std::vector<std::string> const& solutionOrder();

/// Adds a solution that was recorded by playing (Session::record()). A number is added to its name if that is
/// taken. Command::selects is empty: solutions are no objects.
[[nodiscard]] Command addSolution(Json const& level, Solution const& solution);
/// Records a solution again: its placements, wires, inputs, changes and frames are replaced; its name, and
/// whether it is expected to solve the level, stay.
[[nodiscard]] Command recordAgain(Json const& level, std::string const& name, Solution const& solution);
[[nodiscard]] Command renameSolution(Json const& level, std::string const& name, std::string const& to);
[[nodiscard]] Command removeSolution(Json const& level, std::string const& name);
/// Whether the run must solve the level, or must not.
[[nodiscard]] Command expectSolved(Json const& level, std::string const& name, bool solved);
/// How many frames of 1/60 s the run has; 0: decided by the program that runs it.
[[nodiscard]] Command setSolutionFrames(Json const& level, std::string const& name, int frames);
[[nodiscard]] Command moveSolution(Json const& level, std::size_t from, std::size_t to);

// The single entries of a solution (solution_entries.cpp): placements, wires, inputs, changes of accuracy.
// The solution is referred to by its name, a list by its key in files ("inputs"), an entry by its index in
// the file's list. What does not exist throws CommandError, and so does an entry that is neither an object
// nor a list. What an entry means is checked by the list of problems.

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
