// trembler solve: searches for solutions of levels.
#include "game/app/commands.hpp"
#include "game/app/mods/mods.hpp"
#include "game/app/options/files/file_rules.hpp"
#include "game/app/options/files/inputs.hpp"
#include "game/app/options/files/level_paths.hpp"
#include "game/app/options/values/number_options.hpp"
#include "game/app/search/solve_table.hpp"
#include "runtime/file/visible_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <limits>
#include <memory>
#include <system_error>

namespace trembler {
namespace {

constexpr std::uint64_t usualRuns = 2000;

/// Whether one table is made of them; else the single level is described at length.
bool isMany(std::vector<std::string> const& paths) {
    std::error_code ignored;
    return paths.size() > 1 || std::filesystem::is_directory(paths.front(), ignored);
}

std::string dumped(nlohmann::ordered_json const& all) {
    return escapedJson(all.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) + "\n";
}

void sayAtLength(std::ostream& out, SearchedLevel const& level, LevelSummary const& summary) {
    out << visible(level.name) << ": " << countsInWords(level.search) << "\n";
    for (std::string const& line : summary.lines) {
        out << visibleLines(line) << "\n";
    }
    if (level.search.found.empty()) {
        out << fmt::format("  the nearest miss: {:.3f}\n", level.search.nearest);
    }
    if (level.chance) {
        out << "  placed at random: " << countsInWords(*level.chance) << "\n";
    }
    if (level.seconds) {
        out << fmt::format("  {:.1f} s, {:.0f} runs per second\n", *level.seconds,
                           level.runsPerSecond().value_or(0));
    }
}

nlohmann::ordered_json summaryOf(std::vector<SearchedLevel> const& levels, SolveArguments const& arguments,
                                 std::uint64_t runs, bool complete) {
    auto const count = [&](auto const& solves) {
        return std::count_if(levels.begin(), levels.end(), solves);
    };
    nlohmann::ordered_json all;
    all["seed"] = arguments.seed;
    all["runs"] = runs;
    all["complete"] = complete;
    all["solved_by_search"] = count([](SearchedLevel const& level) { return level.search.solved > 0; });
    if (arguments.compare) {
        all["solved_at_random"] =
            count([](SearchedLevel const& level) { return level.chance && level.chance->solved > 0; });
    }
    return all;
}

int solveLevels(SolveArguments const& arguments) {
    bool const many = isMany(arguments.levels);
    GameDataByMods data(arguments.mods);
    Outputs outputs;
    std::vector<std::filesystem::path> files{arguments.levels.front()};
    if (many) {
        GameData const plain; // without mods
        files = levelsNamed(plain, arguments.levels);
        readsAll(outputs, plain);
    } else {
        readsAll(outputs, data.dataFor(files.front()));
    }
    for (auto const& file : files) {
        readsLevel(outputs, data, file);
    }
    outputs.claimFile("--resume", arguments.work.resume, "a file");
    std::vector<std::unique_ptr<insight::LevelUnderTest>> levels; // all, so that a fault is reported at once
    for (auto const& file : files) {
        levels.push_back(std::make_unique<insight::LevelUnderTest>(data.dataFor(file), file));
    }
    std::vector<std::unique_ptr<KeptInLevel>> inLevels(files.size());
    WorkPlace place(arguments.work);
    OutputFile* json = nullptr;
    OutputFile* markdown = nullptr;
    place.asLeader([&] {
        for (std::size_t i = 0; arguments.addToLevel && i < files.size(); ++i) {
            inLevels[i] = std::make_unique<KeptInLevel>(data.dataFor(files[i]), files[i]);
        }
        json = outputs.add("--json", arguments.json);
        markdown = outputs.add("--markdown", arguments.markdown);
    });
    // The minutes are those of all levels together: the first of several must not use them up.
    std::uint64_t const runs = arguments.runs.value_or(
        arguments.work.minutes && !many ? std::numeric_limits<std::uint64_t>::max() / 2 : usualRuns);
    bool const words = json == nullptr || !json->isStandardOutput();
    std::vector<SearchedLevel> searched;
    nlohmann::ordered_json entries = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < files.size() && !place.workers().stopped(); ++i) {
        searched.push_back(searchLevel(*levels[i], files[i], arguments, runs, many, place));
        if (!place.leads()) {
            continue;
        }
        LevelSummary summary =
            summaryOf(searched.back(), *levels[i], arguments, outputs, inLevels[i].get(), place);
        place.clearProgress();
        if (words && many) {
            outputs.words() << visible(solveLine(searched.back())) << std::endl; // as it comes
        } else if (words) {
            sayAtLength(outputs.words(), searched.back(), summary);
        }
        entries.push_back(std::move(summary.json));
    }
    place.clearProgress();
    if (!place.leads()) {
        return exitSolved;
    }
    bool const complete = !place.workers().stopped();
    if (words && many) {
        outputs.words() << solveSummary(searched) << "\n";
    }
    if (json != nullptr && many) {
        nlohmann::ordered_json all = summaryOf(searched, arguments, runs, complete);
        all["levels"] = std::move(entries);
        json->stream() << dumped(all);
    } else if (json != nullptr) {
        json->stream() << dumped(entries.front());
    }
    if (markdown != nullptr) {
        markdown->stream() << solveTable(searched);
    }
    outputs.finish();
    if (!complete && !arguments.work.minutes) {
        std::cerr << "trembler: stopped; this is what was found so far"
                  << (arguments.work.resume ? ", and the same command goes on from there" : "") << "\n";
    }
    bool const all = searched.size() == files.size() &&
                     std::all_of(searched.begin(), searched.end(),
                                 [](SearchedLevel const& level) { return !level.search.found.empty(); });
    return all ? exitSolved : exitNotSolved;
}

} // namespace

void addSolveCommand(CLI::App& program, Work& work) {
    auto const arguments = std::make_shared<SolveArguments>();
    CLI::App* const command = program.add_subcommand(
        "solve",
        "Search for solutions of levels: parts of the toolbox in places of interest and at random, and "
        "changes of the nearest misses, with simple things done by hand. One solution of each kind is "
        "reported, "
        "reduced to what it needs; of several levels, or of a folder, a line each. Exit status: 0 found some "
        "of each level, 1 none of one, 2 bad input or output.");
    addLevels(*command, "LEVEL", arguments->levels, "Level files or folders (required)");
    addNumber(*command, "--runs", arguments->runs, 1, 100'000'000,
              "Runs to try, of each level (default: 2000, or, of one level, as many as --minutes allows)");
    addNumber(*command, "--minutes", arguments->work.minutes, 0.01, 100'000,
              "Stop after that time; the result then depends on this computer's speed");
    addNumber(*command, "--seed", arguments->seed, 0, 1'000'000'000,
              "The same seed and number of runs find the same")
        ->default_str("1");
    addNumber(*command, "--frames", arguments->frames, 1, 36'000, "Frames of a run, at most")
        ->default_str("1200");
    command->add_flag("--no-hands", arguments->noHands, "Only place parts and lay wires");
    command->add_flag("--random", arguments->random, "Place parts at random instead");
    command->add_flag("--compare", arguments->compare, "Afterwards place parts at random in as many runs");
    addOptionalFile(*command, "--json", arguments->json, file_kinds::json,
                    "Write one JSON object; on the terminal it replaces the words");
    addOptionalFile(*command, "--markdown", arguments->markdown, file_kinds::markdown,
                    "Write a table of the levels");
    addOutputFolder(
        *command, "--keep", arguments->keep,
        "Write each found solution, for `trembler run --solution`, and a picture of it; no file is "
        "replaced");
    command->add_flag("--add-to-level", arguments->addToLevel,
                      "Add found solutions of kinds that nobody recorded to the level's own file; all else "
                      "in it stays as it is");
    addWorkerOptions(*command, arguments->work);
    addModFolders(*command, arguments->mods);
    command->footer(outputConvention);
    command->callback([command, arguments, &work] {
        takeBack(*command, "LEVEL", arguments->levels, "--json", arguments->json);
        takeBack(*command, "LEVEL", arguments->levels, "--markdown", arguments->markdown);
        if (arguments->levels.empty()) {
            throw CLI::RequiredError("LEVEL");
        }
        work = [arguments] { return solveLevels(*arguments); };
    });
}

} // namespace trembler
