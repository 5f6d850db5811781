// The option --solution NAME|FILE.
#pragma once

#include "puzzle/data/game_data.hpp"
#include "puzzle/session/session.hpp"
#include "puzzle/solutions/solution_file.hpp"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <string>

namespace trembler {

/// Adds --solution. Which solutions there are depends on the level, see solutionStated().
CLI::Option* addSolution(CLI::App& command, std::string& target, std::string const& meaning);
/// findOrLoadSolution() whose std::invalid_argument names the option.
[[nodiscard]] Solution solutionStated(Registry const& registry, LevelFile const& level,
                                      std::string const& nameOrFile);
/// A session at the level, with the solution if one is stated. Throws what reading the level, and the
/// solution, throws.
[[nodiscard]] std::unique_ptr<Session> sessionStated(GameData const& data, std::filesystem::path const& level,
                                                     std::string const& nameOrFile);

} // namespace trembler
