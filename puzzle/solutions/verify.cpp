#include "puzzle/solutions/verify.hpp"

#include "puzzle/campaign/as_played.hpp"
#include "puzzle/checks/level_checks.hpp"
#include "puzzle/run/runner.hpp"
#include "runtime/level/read/read_level.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler {
namespace {

constexpr std::uint64_t handsOffFrames = 3600;
constexpr std::uint64_t solutionFrames = 3600;

RunReport runOnce(GameData const& gameData, LevelFile const& level, Solution const* solution, int threads) {
    WorldOptions options;
    options.threads = threads;
    options.detail = level.detail;
    Session session(gameData.registry, gameData.parts, level, options);
    RunOptions run;
    run.frames = handsOffFrames;
    if (solution != nullptr) {
        session.load(*solution);
        run.frames = solution->frames ? static_cast<std::uint64_t>(*solution->frames) : solutionFrames;
    }
    run.hashEvery = 60;
    run.stopWhenSolved = solution == nullptr || (solution->solves && !solution->frames);
    return trembler::run(session, "", run);
}

void addWarnings(std::vector<std::string>& failures, std::string const& name, RunReport const& report) {
    for (std::string const& warning : report.warnings) {
        failures.push_back(fmt::format("{}: {}", name, warning));
    }
}

bool sameHashes(RunReport const& a, RunReport const& b) {
    if (a.hashes.size() != b.hashes.size() || a.stateHash != b.stateHash) {
        return false;
    }
    for (std::size_t i = 0; i < a.hashes.size(); ++i) {
        if (a.hashes[i].hash != b.hashes[i].hash) {
            return false;
        }
    }
    return true;
}

/// A demonstration's task must need the player, and one of the recorded solutions must fulfil it.
void checkTask(std::vector<std::string>& failures, GameData const& gameData, LevelFile const& level,
               std::string const& name) {
    LevelFile const played = asPlayed(level, "");
    if (runOnce(gameData, played, nullptr, 1).solved) {
        failures.push_back(fmt::format("{}: its task is fulfilled hands off", name));
    }
    bool const done = std::any_of(played.solutions.begin(), played.solutions.end(), [&](Solution one) {
        one.solves = true;
        return runOnce(gameData, played, &one, 1).solved;
    });
    if (!done) {
        failures.push_back(fmt::format("{}: no recorded solution fulfils its task", name));
    }
}

} // namespace

std::vector<std::string> verifyLevel(GameData const& gameData, std::filesystem::path const& path,
                                     std::map<std::string, std::string> const& detail) {
    std::vector<std::string> failures;
    std::string const name = gameData.shortName(path);
    try {
        auto const document = JsonDocument::load(path);
        LevelCheckup const checkup = checkWholeLevel(gameData, document, detail);
        for (Diagnostic const& problem : checkup.problems) {
            failures.push_back(problem.print());
        }
        if (!checkup.playable || checkup.crowded) { // a crowded one would be computed for hours
            return failures;
        }
        LevelFile level = readLevel(gameData.registry, document);
        for (auto const& [effect, name] : detail) {
            level.detail[effect] = name;
        }
        for (Diagnostic const& lacking : checkup.lacking) {
            failures.push_back(fmt::format("{}: {}", name, lacking.message));
        }
        RunReport const handsOff = runOnce(gameData, level, nullptr, 1);
        addWarnings(failures, name, handsOff);
        if (handsOff.solved && !level.demonstration) {
            failures.push_back(fmt::format("{}: solved by an empty toolbox, in frame {}", name,
                                           handsOff.solvedFrame.value_or(0)));
        }
        if (!handsOff.solved && level.demonstration) {
            failures.push_back(
                fmt::format("{}: a demonstration, but hands off it does not reach its goals", name));
        }
        if (!sameHashes(handsOff, runOnce(gameData, level, nullptr, 3))) {
            failures.push_back(fmt::format("{}: hands off, 1 and 3 threads end in different states", name));
        }
        if (!level.task.is_null()) {
            checkTask(failures, gameData, level, name);
        }
        for (Solution const& solution : level.solutions) {
            RunReport const report = runOnce(gameData, level, &solution, 1);
            addWarnings(failures, fmt::format("{}: solution '{}'", name, solution.name), report);
            if (report.solved != solution.solves) {
                failures.push_back(
                    fmt::format("{}: solution '{}' was recorded as {} but {}", name, solution.name,
                                solution.solves ? "solving the level" : "not solving the level",
                                report.solved ? "solves it" : "does not"));
            }
            if (!sameHashes(report, runOnce(gameData, level, &solution, 2))) {
                failures.push_back(fmt::format(
                    "{}: solution '{}' ends in different states on 1 and 2 threads", name, solution.name));
            }
        }
    } catch (InputError const& error) {
        for (Diagnostic const& diagnostic : error.diagnostics()) {
            std::string const printed = diagnostic.print(); // a refused placement was found before the run
            if (std::find(failures.begin(), failures.end(), printed) == failures.end()) {
                failures.push_back(printed);
            }
        }
    } catch (std::exception const& error) {
        failures.push_back(fmt::format("{}: {}", name, error.what()));
    }
    return failures;
}

} // namespace trembler
