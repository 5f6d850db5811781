// trembler verify: checks whether every level is valid.
#include "game/app/commands.hpp"
#include "puzzle/data/game_data.hpp"
#include "puzzle/solutions/verify.hpp"
#include "runtime/file/visible_text.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <unistd.h>

namespace trembler {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> levelsUnder(fs::path const& path) {
    if (!fs::is_directory(path)) {
        return {path};
    }
    std::vector<fs::path> found;
    for (fs::directory_entry const& entry : fs::recursive_directory_iterator(path)) {
        bool const schema = entry.path().filename().string().ends_with(".schema.json");
        if (entry.is_regular_file() && entry.path().extension() == ".json" && !schema) {
            found.push_back(entry.path());
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

int verifyAll(std::vector<std::string> const& paths, std::vector<std::string> const& detail) {
    GameData const gameData;
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
    }
    if (levels.empty()) {
        throw std::invalid_argument(
            fmt::format("there is no level in {}", (gameData.home / "levels").string()));
    }
    bool valid = true;
    for (fs::path const& level : levels) {
        std::vector<std::string> const failures = verifyLevel(gameData, level, detailOf(detail));
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
    auto const paths = std::make_shared<std::vector<std::string>>();
    CLI::App* const command = program.add_subcommand(
        "verify",
        "Check levels: valid, not solved by an empty toolbox (unless it is a demonstration), every recorded "
        "solution does what it says, and always in the same way. A line per failure, exit status 1 if any.");
    command->add_option("PATH", *paths, "Level files or folders (default: all levels)");
    auto const detail = std::make_shared<std::vector<std::string>>();
    command
        ->add_option("--detail", *detail,
                     "EFFECT=LEVEL: check them with this detail level, for example dynamics=ode")
        ->allow_extra_args(false); // otherwise the option would take the path for its value
    command->callback(
        [paths, detail, &result] { result = guarded([&] { return verifyAll(*paths, *detail); }); });
}

} // namespace trembler
