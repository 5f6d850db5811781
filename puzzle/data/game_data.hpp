// The data that every command needs: all components, all parts, and the places of the files.
#pragma once

#include "runtime/level/model/part_library.hpp"
#include "runtime/world/registry.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace trembler {

/// The folder that holds assets/ and levels/: $TREMBLER_HOME if set, else the first folder upwards from the
/// running program that has both, or whose share/trembler has both (an installed program), else the folder
/// that the program was built from.
[[nodiscard]] std::filesystem::path homeFolder();

struct GameData {
    Registry registry;
    PartLibrary parts;
    std::filesystem::path home;

    /// Registers every effect and reads every part. Throws InputError if a part definition is wrong.
    GameData();
    GameData(GameData const&) = delete;
    GameData& operator=(GameData const&) = delete;

    /// Every level file under levels/, in order of path.
    [[nodiscard]] std::vector<std::filesystem::path> levels() const;
    /// The path of a level as a person would name it: relative to home if it lies there.
    [[nodiscard]] std::string shortName(std::filesystem::path const& level) const;
};

} // namespace trembler
