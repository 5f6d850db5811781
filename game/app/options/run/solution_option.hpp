// The option --solution NAME|FILE.
#pragma once

#include "puzzle/data/game_data.hpp"
#include "puzzle/solutions/solution_file.hpp"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>

namespace trembler {

/// Adds --solution. Which solutions there are depends on the level, see solutionStated().
CLI::Option* addSolution(CLI::App& command, std::string& target, std::string const& meaning);
/// findOrLoadSolution() whose std::invalid_argument names the option.
[[nodiscard]] Solution solutionStated(Registry const& registry, LevelFile const& level,
                                      std::string const& nameOrFile);
/// For commands that leave the reading to others: throws what reading the level, and the solution if one is
/// stated, throws.
void checkSolutionStated(GameData const& data, std::filesystem::path const& level,
                         std::string const& nameOrFile);

} // namespace trembler
