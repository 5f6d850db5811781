// A solution by name from its level, or from a file of its own.
#pragma once

#include "runtime/level/model/level.hpp"
#include "runtime/world/registry.hpp"

#include <filesystem>
#include <string>

namespace trembler {

/// The solution in a file of its own, checked against the level as far as that is possible without a world.
/// Throws InputError if the file cannot be read or is wrong.
[[nodiscard]] Solution loadSolution(Registry const& registry, LevelFile const& level,
                                    std::filesystem::path const& file);

/// The solution of that name in the level; else that of the file of that name, which holds one solution in
/// the form of a level file. Throws InputError if the file is wrong; std::invalid_argument, listing the
/// level's solutions but not naming the one looked for, if there is neither.
[[nodiscard]] Solution findOrLoadSolution(Registry const& registry, LevelFile const& level,
                                          std::string const& nameOrFile);

} // namespace trembler
