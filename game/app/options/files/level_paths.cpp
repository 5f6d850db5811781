#include "game/app/options/files/level_paths.hpp"

#include "puzzle/campaign/chapter.hpp"
#include "puzzle/data/game_data.hpp"
#include "runtime/level/json/diagnostic.hpp"
#include "runtime/level/json/refuse_file.hpp"
#include "runtime/level/read/folder_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <set>
#include <stdexcept>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace trembler {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuseToRead(fs::path const& path, std::error_code const& error) {
    refuseFile(path.string(), "cannot be read: " + error.message(), "");
}

/// Of a mod's files only those in levels/ and tests/ are levels; hidden files are settings of editors.
bool isNoLevel(fs::path const& file) {
    if (file.filename() == "mod.json" || file.filename().string().starts_with('.')) {
        return true;
    }
    fs::path const folder = file.parent_path();
    std::error_code error;
    return folder.filename() == "parts" && fs::exists(folder.parent_path() / "mod.json", error);
}

std::vector<fs::path> levelsUnder(fs::path const& path) {
    std::error_code error;
    if (!fs::is_directory(path, error)) {
        return {path};
    }
    std::vector<fs::path> found;
    fs::path last; // where the iterator was before an error, which sets it to the end
    error.clear();
    for (fs::recursive_directory_iterator at(path, error), end; !error && at != end; at.increment(error)) {
        std::error_code unknown;
        last = at->path();
        if (at->is_regular_file(unknown) && at->path().extension() == ".json" && !isNotALevel(at->path()) &&
            !isNoLevel(at->path())) {
            found.push_back(at->path());
        }
        if (found.size() > limits::levelFiles) {
            throw std::invalid_argument(fmt::format("{}: has more than {} levels; expected at most {}",
                                                    path.string(), limits::levelFiles, limits::levelFiles));
        }
    }
    if (error) { // a folder in it that may not be looked into could hold levels
        std::error_code unknown;
        refuseToRead(fs::is_directory(last, unknown) ? last : path, error);
    }
    std::sort(found.begin(), found.end());
    return found;
}

/// Throws InputError if the file is not there or may not be read.
void checkReadable(fs::path const& file) {
    std::error_code error;
    (void)fs::file_size(file, error);
    if (!error && ::access(file.c_str(), R_OK) != 0) {
        error = std::error_code(errno, std::generic_category());
    }
    if (error) {
        refuseToRead(file, error);
    }
}

} // namespace

std::vector<fs::path> levelsNamed(GameData const& gameData, std::vector<std::string> const& paths) {
    std::vector<fs::path> levels;
    for (std::string const& path : paths) {
        std::vector<fs::path> const found = levelsUnder(path);
        if (found.empty()) {
            throw std::invalid_argument(fmt::format("there is no level in {}", path));
        }
        levels.insert(levels.end(), found.begin(), found.end());
    }
    if (paths.empty()) {
        levels = gameData.levels();
        std::error_code error;
        if (fs::is_directory(gameData.home / "mods", error)) {
            std::vector<fs::path> const ofMods = levelsUnder(gameData.home / "mods");
            levels.insert(levels.end(), ofMods.begin(), ofMods.end());
        }
    }
    if (levels.empty()) {
        throw std::invalid_argument(
            fmt::format("there is no level in {}", (gameData.home / "levels").string()));
    }
    for (fs::path const& level : levels) {
        checkReadable(level);
    }
    // A file that is stated and in a folder that is stated, or has two names, is one level.
    std::set<fs::path> before;
    std::erase_if(levels, [&](fs::path const& level) {
        std::error_code error;
        fs::path same = fs::weakly_canonical(level, error);
        return !before.insert(error ? level : std::move(same)).second;
    });
    return levels;
}

} // namespace trembler
