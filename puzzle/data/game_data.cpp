#include "puzzle/data/game_data.hpp"

#include "lua/attach/register.hpp"
#include "lua/mods/trust.hpp"
#include "puzzle/campaign/chapter.hpp"
#include "puzzle/data/effects.hpp"
#include "puzzle/data/own_part_files.hpp"
#include "runtime/file/data_folder.hpp"
#include "runtime/file/folder_files.hpp"
#include "runtime/level/build/check_composites.hpp"
#include "runtime/level/read/folder_limits.hpp"
#include "runtime/level/read/read_part.hpp"

#include <cstdlib>
#include <system_error>
#include <utility>

namespace trembler {
namespace {

namespace fs = std::filesystem;

bool hasFiles(fs::path const& folder) {
    std::error_code error;
    return fs::is_directory(folder / "assets", error) && fs::is_directory(folder / "levels", error);
}

} // namespace

fs::path homeFolder() {
    if (char const* const stated = std::getenv("TREMBLER_HOME"); stated != nullptr && *stated != '\0') {
        return stated;
    }
    std::error_code error;
    for (fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
         folder.has_relative_path(); folder = folder.parent_path()) {
        if (hasFiles(folder)) {
            return folder;
        }
        if (fs::path const installed = folder / "share" / "trembler"; hasFiles(installed)) {
            return installed;
        }
    }
    return TREMBLER_SOURCE_DIR;
}

fs::path ownPartsFolder() {
    return inDataFolder("parts");
}

GameData::GameData() : GameData(std::vector<lua::Mod>()) {}

GameData::GameData(std::vector<lua::Mod> loaded)
    : home(homeFolder()), mods(std::move(loaded)), scriptLog(std::make_shared<lua::ScriptLog>()) {
    registerEffects(registry);
    for (lua::Mod& mod : mods) {
        std::error_code error;
        mod.bundled = fs::equivalent(mod.folder.parent_path(), home / "mods", error);
    }
    lua::applyTrust(mods, {}); // the mods that come with the program; the caller has decided on all others
    Problems problems;
    scripts = lua::registerMods(registry, mods, scriptLog, problems);
    problems.throwIfAny();
    parts = loadParts(registry, home / "assets" / "parts");
    PartLimits most; // of all mods together: each of them may state the most
    for (lua::Mod const& mod : mods) {
        std::error_code error;
        if (!fs::is_directory(mod.partFolder(), error)) {
            continue;
        }
        PartLibrary const library = loadParts(registry, mod.partFolder(), most);
        for (PartDefinition const* part : library.all()) {
            most.before += part->document == nullptr ? 0 : part->document->text().size();
            parts.add(*part);
        }
    }
    checkComposites(parts); // a mod's parts may consist of others
    ownPartFaults = addOwnParts(registry, ownPartsFolder(), parts, ownPartLimits, &damagedOwnParts);
}

std::vector<fs::path> GameData::levels() const {
    FirstPaths found(limits::levelFiles);
    std::error_code error;
    for (fs::recursive_directory_iterator at(home / "levels", error), end; !error && at != end;
         at.increment(error)) {
        fs::path const& path = at->path();
        std::error_code none;
        if (at->is_directory(none) && fs::exists(path / "mod.json", none)) {
            at.disable_recursion_pending(); // a mod beside the levels of a pack
            continue;
        }
        if (at->is_regular_file(error) && path.extension() == ".json" && !isNotALevel(path)) {
            found.add(path);
        }
    }
    return found.sorted();
}

std::string GameData::shortName(fs::path const& level) const {
    std::error_code error;
    fs::path const relative = fs::relative(level, home, error);
    return error || relative.empty() || *relative.begin() == ".." ? level.string() : relative.string();
}

} // namespace trembler
