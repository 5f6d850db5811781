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

} // namespace trembler::edit
