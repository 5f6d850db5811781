// Reading a level by the one check that everything does which runs or shows a level: the commands, the
// window, reports and verification. So a level that one of them refuses is refused by all, with the same
// words.
#pragma once

#include "runtime/level/build/build_world.hpp"
#include "runtime/level/model/level.hpp"
#include "runtime/level/model/part_library.hpp"
#include "runtime/world/registry.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace trembler {

/// Builds the world of a level and sets up its goals and, if it has one, its task, whether they are asked for
/// or not. Throws InputError, with the places in the file, if any of it is wrong.
[[nodiscard]] BuiltLevel checkPlayable(Registry const& registry, PartLibrary const& parts,
                                       LevelFile const& level);

/// The level of a file. Throws InputError if it cannot be read or checkPlayable() refuses it. `detail`
/// overrides the detail levels that the level states.
[[nodiscard]] LevelFile loadPlayable(Registry const& registry, PartLibrary const& parts,
                                     std::filesystem::path const& file,
                                     std::map<std::string, std::string> const& detail = {});

/// What the author should know about a level that can be played all the same, for the commands that do not
/// verify it; one line each. See complainAboutMatter(). Throws InputError like checkPlayable().
[[nodiscard]] std::vector<std::string> doubtsAbout(Registry const& registry, PartLibrary const& parts,
                                                   LevelFile const& level,
                                                   std::map<std::string, std::string> const& detail = {});

} // namespace trembler
