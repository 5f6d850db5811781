// Reading a level by the one check that everything does which runs or shows a level: the commands, the
// window, reports and verification. So a level that one of them refuses is refused by all, with the same
// words.
#pragma once

#include "puzzle/session/ready_level.hpp"
#include "runtime/level/model/part_library.hpp"
#include "runtime/world/registry.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace trembler {

/// Builds the world of a level and sets up its goals and, if it has one, its task, whether they are asked for
/// or not. Throws InputError, with the places in the file, if any of it is wrong.
[[nodiscard]] BuiltLevel checkPlayable(Registry const& registry, PartLibrary const& parts,
                                       LevelFile const& level, WorldOptions options = {});

/// The level of a file, with the world that checkPlayable() has built: a session takes it over, so that
/// nothing is built twice. Throws InputError if the file cannot be read or checkPlayable() refuses the level.
[[nodiscard]] ReadyLevel loadPlayable(Registry const& registry, PartLibrary const& parts,
                                      std::filesystem::path const& file, WorldOptions options = {});

/// What the author should know about a level that can be played all the same, for the commands that do not
/// verify it; one line each. `built` is what checkPlayable() has made. See complainAboutMatter().
[[nodiscard]] std::vector<std::string> doubtsAbout(PartLibrary const& parts, LevelFile const& level,
                                                   BuiltLevel const& built);

} // namespace trembler
