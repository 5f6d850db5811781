// Shared by the tests of levels: the registry of all effects, the parts, and a small level.
#pragma once

#include "runtime/level/build/build_world.hpp"
#include "runtime/level/read/read_level.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace trembler {

/// Every effect, and every part in assets/parts.
struct LevelKit {
    LevelKit();
    Registry registry;
    PartLibrary parts;
};

[[nodiscard]] LevelKit const& levelKit();
/// A level that uses every section of the format.
[[nodiscard]] std::string sampleLevel();
/// All level files of the project.
[[nodiscard]] std::vector<std::filesystem::path> levelFiles();
[[nodiscard]] std::filesystem::path sourceFolder();

} // namespace trembler
