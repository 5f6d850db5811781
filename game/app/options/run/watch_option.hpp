// The option --watch OBJECT.FIELD.
#pragma once

#include "runtime/world/registry.hpp"
#include "runtime/world/world.hpp"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace trembler {

/// Adds --watch. Which fields there are depends on the level, see checkWatched().
CLI::Option* addWatch(CLI::App& command, std::vector<std::string>& target, std::string const& meaning);
/// Throws std::invalid_argument, naming the option, if a value names no field of the world.
void checkWatched(Registry const& registry, World const& world, std::vector<std::string> const& options);

} // namespace trembler
