// Options of the form KEY=VALUE: --detail EFFECT=LEVEL and --period COMPONENT=N.
#pragma once

#include "runtime/world/registry.hpp"

#include <CLI/CLI.hpp>

#include <map>
#include <string>
#include <vector>

namespace trembler {

/// Adds --detail. Effects and levels that the program does not have are refused, and two levels of an effect.
CLI::Option* addDetail(CLI::App& command, std::vector<std::string>& target, std::string const& meaning);
/// The levels of such values, by effect.
[[nodiscard]] std::map<std::string, std::string> detailOf(std::vector<std::string> const& options);

/// Adds --period. Whether there is such a component depends on the level's mods, see periodsOf().
CLI::Option* addPeriod(CLI::App& command, std::vector<std::string>& target, std::string const& meaning);
/// The periods of such values in frames, by component. Throws std::invalid_argument, naming the option, if
/// the registry has no component of a name, or several.
[[nodiscard]] std::map<std::string, int> periodsOf(Registry const& registry,
                                                   std::vector<std::string> const& options);

} // namespace trembler
