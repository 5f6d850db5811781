// The data that every command needs: all components, all parts, and the places of the files.
#pragma once

#include "lua/attach/live_script.hpp"
#include "lua/component/script_log.hpp"
#include "lua/mods/mod.hpp"
#include "runtime/file/kept_file.hpp"
#include "runtime/level/json/diagnostic.hpp"
#include "runtime/level/model/part_library.hpp"
#include "runtime/world/registry.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace trembler {

/// The folder that holds assets/ and levels/: $TREMBLER_HOME if set, else the first folder upwards from the
/// running program that has both, or whose share/trembler has both (an installed program), else the folder
/// that the program was built from.
[[nodiscard]] std::filesystem::path homeFolder();

/// The folder of the player's own parts, which levels may use as those of the game:
/// parts/ in dataFolder(). Empty if there is none.
[[nodiscard]] std::filesystem::path ownPartsFolder();

struct GameData {
    Registry registry;
    PartLibrary parts;
    std::filesystem::path home;
    std::vector<lua::Mod> mods; ///< the loaded ones
    /// Own parts that cannot be used, for a message of the editor; a level that needs one says so itself.
    std::vector<Diagnostic> ownPartFaults;
    /// Files of own parts that are damaged. They were only looked at: commands move nothing of the player's.
    std::vector<DamagedFile> damagedOwnParts;
    std::shared_ptr<lua::ScriptLog> scriptLog;       ///< messages of their scripts
    std::shared_ptr<lua::LiveScripts const> scripts; ///< their scripts, which can change while worlds run

    /// Registers every effect and reads every part. Throws InputError if a part definition is wrong; one of
    /// the player's own is left out, see ownPartFaults.
    GameData();
    /// The same with mods. Throws InputError also if one of them is wrong.
    explicit GameData(std::vector<lua::Mod> mods);
    GameData(GameData const&) = delete;
    GameData& operator=(GameData const&) = delete;

    /// Every level file under levels/, in order of path.
    [[nodiscard]] std::vector<std::filesystem::path> levels() const;
    /// The path of a level as a person would name it: relative to home if it lies there.
    [[nodiscard]] std::string shortName(std::filesystem::path const& level) const;
};

} // namespace trembler
