// trembler verify: checks whether every level is valid.
#include "game/app/commands.hpp"
#include "game/app/mods/mods.hpp"
#include "game/app/options/files/file_rules.hpp"
#include "game/app/options/files/inputs.hpp"
#include "game/app/options/files/level_paths.hpp"
#include "game/app/options/files/outputs.hpp"
#include "game/app/options/values/assignments.hpp"
#include "game/app/search/verification_key.hpp"
#include "insight/spread/mpi_team.hpp"
#include "insight/spread/workers.hpp"
#include "puzzle/data/game_data.hpp"
#include "runtime/file/visible_text.hpp"
#include "runtime/level/json/diagnostic.hpp"
#include "runtime/level/json/json_document.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <span>

namespace trembler {
namespace {

namespace fs = std::filesystem;

struct VerifyArguments {
    std::vector<std::string> paths;
    std::vector<std::string> detail;
    std::vector<std::string> mods; // folders in which mods are looked for
    OutputTarget json;
    OutputTarget resume;
    bool mpi = false;
};

/// Whether a file holds a level, valid or not.
bool isLevel(fs::path const& file) {
    try {
        return JsonDocument::load(file)->root().contains("objects");
    } catch (InputError const&) {
        return false;
    }
}

/// A failure of the mods that a level names is one of the level.
std::vector<std::string> verifyOne(GameDataByMods& data, fs::path const& level,
                                   std::map<std::string, std::string> const& detail) {
    try {
        return verifyWithScripts(data.dataFor(level), level, detail);
    } catch (InputError const& error) {
        std::vector<std::string> failures;
        for (Diagnostic const& diagnostic : error.diagnostics()) {
            failures.push_back(diagnostic.print());
        }
        return failures;
    }
}

/// The levels that are verified, one piece of work each, on one thread of each process: the messages of
/// scripts are gathered for all levels that share mods.
class Verification {
public:
    Verification(VerifyArguments const& arguments, GameDataByMods& data, std::vector<fs::path> const& levels)
        : data_(data), levels_(levels), detail_(detailOf(arguments.detail)),
          team_(arguments.mpi ? insight::mpiTeam() : std::make_unique<insight::Team>()),
          journal_(arguments.resume ? std::make_unique<insight::Journal>(*arguments.resume, *team_)
                                    : nullptr),
          workers_(
              {.threads = 1, .team = team_.get(), .journal = journal_.get(), .stop = {}, .progress = {}}) {
        if (journal_) { // only then must keys differ between states of a file
            for (fs::path const& level : levels) {
                keys_.push_back(verificationKey(data, level, detail_));
            }
        } else {
            for (fs::path const& level : levels) {
                keys_.push_back(level.string());
            }
        }
        if (team_->size() > 1) {
            results_ = share(keys_, 0);
        }
    }

    [[nodiscard]] bool leads() const { return team_->leads(); }
    /// The failures of a level; the same in all processes.
    [[nodiscard]] std::vector<std::string> failures(std::size_t level) {
        return team_->size() > 1 ? results_[level] : share(std::span(keys_).subspan(level, 1), level).front();
    }

private:
    std::vector<std::vector<std::string>> share(std::span<std::string const> keys, std::size_t first) {
        std::vector<std::vector<std::string>> all;
        for (auto const& result : workers_.share(keys, [&](std::size_t index) {
                 return nlohmann::json(verifyOne(data_, levels_[first + index], detail_))
                     .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
             })) {
            all.push_back(nlohmann::json::parse(*result).get<std::vector<std::string>>());
        }
        return all;
    }

    GameDataByMods& data_;
    std::vector<fs::path> const& levels_;
    std::map<std::string, std::string> detail_;
    std::unique_ptr<insight::Team> team_;
    std::unique_ptr<insight::Journal> journal_;
    insight::Workers workers_;
    std::vector<std::string> keys_;
    std::vector<std::vector<std::string>> results_; // of several processes
};

int verifyAll(VerifyArguments const& arguments) {
    GameData const gameData; // without mods
    GameDataByMods data(arguments.mods);
    std::vector<fs::path> const levels = levelsNamed(gameData, arguments.paths);
    Outputs outputs;
    readsAll(outputs, gameData);
    for (fs::path const& level : levels) {
        readsLevel(outputs, data, level);
    }
    // In `--json LEVEL LEVEL` the parser takes the first level for the FILE.
    if (arguments.json && isLevel(*arguments.json)) {
        outputs.reads(*arguments.json);
    }
    outputs.claimFile("--resume", arguments.resume, "a file");
    Verification verification(arguments, data, levels);
    if (!verification.leads()) {
        return exitSolved;
    }
    OutputFile* const json = outputs.add("--json", arguments.json);
    nlohmann::ordered_json entries = nlohmann::ordered_json::array();
    bool valid = true;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        fs::path const& level = levels[i];
        std::vector<std::string> const failures = verification.failures(i);
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

void addVerifyCommand(CLI::App& program, Work& work) {
    auto const arguments = std::make_shared<VerifyArguments>();
    CLI::App* const command = program.add_subcommand(
        "verify",
        "Check levels: valid, not solved by an empty toolbox (unless it is a demonstration), every recorded "
        "solution has its stated result, and always the same one; no script fails. A line per failure. Exit "
        "status: 0 all valid, 1 not all valid, 2 bad input or output.");
    addLevels(*command, "PATH", arguments->paths,
              "Level files or folders (default: all levels, including those of the mods that come "
              "with the program)");
    addOptionalFile(*command, "--json", arguments->json, file_kinds::json,
                    "Write one JSON object with the failures of each level; on the terminal it replaces the "
                    "words. If there is no other PATH, the name after --json is the PATH");
    addDetail(*command, arguments->detail, "Check them with this detail level, for example dynamics=ode");
    addFile(*command, "--resume", arguments->resume, file_kinds::journal,
            "A file to which the verdict on every level is added as it comes; a level that has not changed "
            "since is not verified again");
    command->add_flag("--mpi", arguments->mpi,
                      "Share the levels out among the processes that mpirun started; the result does not "
                      "depend on their number");
    addModFolders(*command, arguments->mods);
    command->footer(outputConvention);
    command->callback([command, arguments, &work] {
        takeBack(*command, "PATH", arguments->paths, "--json", arguments->json);
        work = [arguments] { return verifyAll(*arguments); };
    });
}

} // namespace trembler
