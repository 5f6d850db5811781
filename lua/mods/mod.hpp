// A mod: a folder with a mod.json, interactions/, parts/, levels/ and tests/.
#pragma once

#include "lua/interaction/manifest.hpp"
#include "runtime/level/json/diagnostic.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace trembler::lua {

struct Mod {
    std::string name; ///< its folder's name
    std::string version;
    std::string author;
    std::string licence;
    std::string text;               ///< its description for people
    std::vector<std::string> needs; ///< other mods
    std::filesystem::path folder;
    bool bundled = false; ///< it came with the program; set where it is loaded
    /// It came with a level, so the player has not installed it: its name in the settings means another mod.
    bool besideLevel = false;
    std::vector<Manifest> interactions; ///< in order of their files

    [[nodiscard]] std::filesystem::path partFolder() const { return folder / "parts"; }
    [[nodiscard]] std::filesystem::path levelFolder() const { return folder / "levels"; }
    /// Levels with recorded solutions, which `trembler mod check` runs.
    [[nodiscard]] std::filesystem::path testFolder() const { return folder / "tests"; }
};

/// Reads a mod with its scripts, but not its parts and levels. Adds everything that is wrong to `problems`.
[[nodiscard]] Mod readMod(std::filesystem::path const& folder, Problems& problems);

/// The folder of mods for a stated folder: the stated one, or the one above it if it is a single mod's.
[[nodiscard]] std::filesystem::path modsFolder(std::filesystem::path const& stated);

/// The folders in which mods are looked for, in order; the first that contains a mod of that name counts.
/// They are the stated folders (each as modsFolder() takes it), the one beside a level's pack, the user's
/// ($XDG_DATA_HOME/trembler/mods), and that of the bundled mods, home/mods.
[[nodiscard]] std::vector<std::filesystem::path> modFolders(std::span<std::string const> stated,
                                                            std::filesystem::path const& level,
                                                            std::filesystem::path const& home);

/// The folder of every mod in these folders, in order of names; of two mods with one name, the first found.
[[nodiscard]] std::vector<std::filesystem::path> listMods(std::span<std::filesystem::path const> folders);

/// The mods with the given names and the mods that these need, in order of their names. Missing and wrong
/// mods are added to `problems`; `by` is the file that needs them.
[[nodiscard]] std::vector<Mod> findMods(std::span<std::string const> names,
                                        std::span<std::filesystem::path const> folders, std::string const& by,
                                        Problems& problems);

/// The names under "mods" in a level's file; none if it cannot be read, which the reader of the level
/// reports.
[[nodiscard]] std::vector<std::string> modsNamedBy(std::filesystem::path const& level);

/// Makes the folder of a new mod with an interaction that works, a level that needs it and a test. Throws
/// std::invalid_argument if the name is not valid or the folder exists.
void writeNewMod(std::filesystem::path const& folder, std::string const& name);

} // namespace trembler::lua
