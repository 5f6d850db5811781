// trembler verify: checks whether every level is valid.
#include "game/app/commands.hpp"
#include "game/app/inputs.hpp"
#include "game/app/outputs.hpp"
#include "puzzle/data/game_data.hpp"
#include "puzzle/solutions/verify.hpp"
#include "runtime/file/visible_text.hpp"
#include "runtime/level/json/json_document.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
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

struct VerifyArguments {
    std::vector<std::string> paths;
    std::vector<std::string> detail;
    OutputTarget json;
};

/// Whether a file holds a level, valid or not.
bool isLevel(fs::path const& file) {
    try {
        return JsonDocument::load(file)->root().contains("objects");
    } catch (InputError const&) {
        return false;
    }
}

/// Throws InputError if the file is not there or may not be read.
void checkReadable(fs::path const& file) {
    std::error_code error;
    (void)fs::file_size(file, error);
    if (!error && ::access(file.c_str(), R_OK) != 0) {
        error = std::error_code(errno, std::generic_category());
    }
    if (error) {
        Diagnostic problem;
        problem.file = file.string();
        problem.message = "cannot be read: " + error.message();
        throw InputError({problem});
    }
}

std::vector<fs::path> levelsOf(GameData const& gameData, std::vector<std::string> const& paths) {
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
    for (fs::path const& level : levels) {
        checkReadable(level);
    }
    return levels;
}

int verifyAll(VerifyArguments const& arguments) {
    GameData const gameData;
    std::vector<fs::path> const levels = levelsOf(gameData, arguments.paths);
    Outputs outputs;
    readsAll(outputs, gameData);
    for (fs::path const& level : levels) {
        outputs.reads(level);
    }
    // In `--json LEVEL LEVEL` the parser takes the first level for the FILE.
    if (arguments.json && isLevel(*arguments.json)) {
        outputs.reads(*arguments.json);
    }
    OutputFile* const json = outputs.add("--json", arguments.json);
    auto const detail = detailOf(arguments.detail);
    nlohmann::ordered_json entries = nlohmann::ordered_json::array();
    bool valid = true;
    for (fs::path const& level : levels) {
        std::vector<std::string> const failures = verifyLevel(gameData, level, detail);
        std::string const name = gameData.shortName(level);
        if (!outputs.terminalTaken()) {
            for (std::string const& failure : failures) {
                std::cout << failure << "\n";
            }
            if (failures.empty()) {
                std::cout << visible(name) << ": valid\n" << std::flush;
            }
        }
        entries.push_back({{"level", name}, {"valid", failures.empty()}, {"failures", failures}});
        valid = valid && failures.empty();
    }
    if (json != nullptr) {
        nlohmann::ordered_json all;
        all["valid"] = valid;
        all["levels"] = std::move(entries);
        json->stream() << escapedJson(
                              all.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace))
                       << "\n";
    }
    outputs.finish();
    return valid ? exitSolved : exitNotSolved;
}

} // namespace

void addVerifyCommand(CLI::App& program, int& result) {
    auto const arguments = std::make_shared<VerifyArguments>();
    CLI::App* const command = program.add_subcommand(
        "verify",
        "Check levels: valid, not solved by an empty toolbox (unless it is a demonstration), every recorded "
        "solution has its stated result, and always the same one. A line per failure. Exit status: 0 all "
        "valid, 1 "
        "not all valid, 2 bad input or output.");
    command->add_option("PATH", arguments->paths, "Level files or folders (default: all levels)");
    addOptionalFile(*command, "--json", arguments->json,
                    "Write one JSON object with the failures of each level; on the terminal it replaces the "
                    "words. If there is no other PATH, the name after --json is the PATH");
    command
        ->add_option("--detail", arguments->detail,
                     "EFFECT=LEVEL: check them with this detail level, for example dynamics=ode")
        ->allow_extra_args(false); // otherwise the option would take the path for its value
    command->footer(outputConvention);
    command->callback([arguments, &result] {
        takeBack(arguments->paths, arguments->json);
        result = guarded([&] { return verifyAll(*arguments); });
    });
}

} // namespace trembler
