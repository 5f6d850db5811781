// trembler verify: checks whether every level is valid.
#include "game/app/commands.hpp"
#include "game/app/mods/mods.hpp"
#include "puzzle/data/game_data.hpp"
#include "runtime/file/visible_text.hpp"
#include "runtime/level/json/diagnostic.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <unistd.h>

namespace trembler {
namespace {

namespace fs = std::filesystem;

/// Of a mod's files only those in levels/ and tests/ are levels.
bool belongsToAMod(fs::path const& file) {
    if (file.filename() == "mod.json") {
        return true;
    }
    fs::path const folder = file.parent_path();
    return folder.filename() == "parts" && fs::exists(folder.parent_path() / "mod.json");
}

std::vector<fs::path> levelsUnder(fs::path const& path) {
    if (!fs::is_directory(path)) {
        return {path};
    }
    std::vector<fs::path> found;
    for (fs::directory_entry const& entry : fs::recursive_directory_iterator(path)) {
        bool const schema = entry.path().filename().string().ends_with(".schema.json");
        if (entry.is_regular_file() && entry.path().extension() == ".json" && !schema &&
            !belongsToAMod(entry.path())) {
            found.push_back(entry.path());
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

struct VerifyArguments {
    std::vector<std::string> paths;
    std::vector<std::string> detail;
    std::vector<std::string> mods; // folders in which mods are looked for
};

/// A failure of the mods that a level names is one of the level.
std::vector<std::string> verifyOne(GameDataByMods& data, fs::path const& level,
                                   std::vector<std::string> const& detail) {
    try {
        return verifyWithScripts(data.dataFor(level), level, detailOf(detail));
    } catch (InputError const& error) {
        std::vector<std::string> failures;
        for (Diagnostic const& diagnostic : error.diagnostics()) {
            failures.push_back(diagnostic.print());
        }
        return failures;
    }
}

int verifyAll(VerifyArguments const& arguments) {
    GameData const gameData; // without mods
    GameDataByMods data(arguments.mods);
    std::vector<std::string> const& paths = arguments.paths;
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
    bool valid = true;
    for (fs::path const& level : levels) {
        std::vector<std::string> const failures = verifyOne(data, level, arguments.detail);
        for (std::string const& failure : failures) {
            std::cout << failure << "\n";
        }
        if (failures.empty()) {
            std::cout << visible(gameData.shortName(level)) << ": valid\n" << std::flush;
        }
        valid = valid && failures.empty();
    }
    return valid ? exitSolved : exitNotSolved;
}

} // namespace

void addVerifyCommand(CLI::App& program, int& result) {
    auto const arguments = std::make_shared<VerifyArguments>();
    CLI::App* const command = program.add_subcommand(
        "verify",
        "Check levels: valid, not solved by an empty toolbox (unless it is a demonstration), every recorded "
        "solution does what it says, and always in the same way; no script fails. A line per failure, exit "
        "status 1 if any.");
    command->add_option("PATH", arguments->paths,
                        "Level files or folders (default: all levels, those of the mods that come with the "
                        "program included)");
    command
        ->add_option("--detail", arguments->detail,
                     "EFFECT=LEVEL: check them with this detail level, for example dynamics=ode")
        ->allow_extra_args(false); // otherwise the option would take the path for its value
    addModFolders(*command, arguments->mods);
    command->callback([arguments, &result] { result = guarded([&] { return verifyAll(*arguments); }); });
}

} // namespace trembler
