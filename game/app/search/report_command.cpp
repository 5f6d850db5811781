// trembler report: the parts and effects that the solutions of levels need, how exact they must be, and other
// ways to solve them.
#include "game/app/commands.hpp"
#include "game/app/mods/mods.hpp"
#include "game/app/options/files/file_rules.hpp"
#include "game/app/options/files/inputs.hpp"
#include "game/app/options/files/level_paths.hpp"
#include "game/app/options/files/outputs.hpp"
#include "game/app/options/values/number_options.hpp"
#include "game/app/search/worker_options.hpp"
#include "insight/report/report_text.hpp"
#include "runtime/file/visible_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>
#include <memory>
#include <utility>

namespace trembler {
namespace {

struct ReportArguments {
    std::vector<std::string> paths;
    std::vector<std::string> mods;
    OutputTarget json;
    OutputTarget markdown;
    WorkerArguments work;
    int runs = 200;
    int drops = 100;
    std::uint64_t seed = 1;
    std::uint64_t search = 0;
    std::optional<double> jitterCm;
    std::optional<double> jitterDegrees;
    std::optional<double> jitterSeconds;
    bool maps = false;
    bool brief = false;
    bool table = false;
    bool sections = false;
    bool each = false;
};

/// `onlyTables`: neither the needed effects nor the chains of causes are shown.
insight::ReportOptions optionsOf(ReportArguments const& arguments, bool onlyTables) {
    insight::ReportOptions options;
    options.robustness.runs = arguments.runs;
    options.robustness.seed = arguments.seed;
    if (arguments.jitterCm) {
        options.robustness.jitter.distance = *arguments.jitterCm / 100;
    }
    options.robustness.jitter.angle = arguments.jitterDegrees.value_or(options.robustness.jitter.angle);
    options.robustness.jitter.seconds = arguments.jitterSeconds.value_or(options.robustness.jitter.seconds);
    options.drops = arguments.drops;
    options.maps = arguments.maps;
    options.costs = !arguments.brief;
    options.search = arguments.search;
    // What is written nowhere is not found out either.
    options.chains = !onlyTables;
    options.effects = !onlyTables;
    return options;
}

/// Options of runs that are not made.
void checkDisplacements(ReportArguments const& arguments, bool seedStated) {
    if (arguments.runs == 0) {
        for (auto const& [name, stated] :
             {std::pair{"--jitter-cm", arguments.jitterCm.has_value()},
              std::pair{"--jitter-degrees", arguments.jitterDegrees.has_value()},
              std::pair{"--jitter-seconds", arguments.jitterSeconds.has_value()}}) {
            if (stated) {
                throw CLI::ValidationError(name, "expected --runs above 0 as well, whose parts and deeds it "
                                                 "displaces");
            }
        }
    }
    if (seedStated && arguments.runs == 0 && arguments.drops == 0 && arguments.search == 0) {
        throw CLI::ValidationError("--seed", "expected --runs, --drops or --search above 0 as well, which "
                                             "displace or search at random");
    }
}

int reportLevels(ReportArguments const& arguments) {
    GameData const gameData; // without mods
    GameDataByMods data(arguments.mods);
    auto const levels = levelsNamed(gameData, arguments.paths);
    Outputs outputs;
    readsAll(outputs, gameData);
    for (auto const& level : levels) {
        readsLevel(outputs, data, level);
    }
    outputs.claimFile("--resume", arguments.work.resume, "a file");
    WorkPlace place(arguments.work);
    OutputFile* json = nullptr;
    OutputFile* markdown = nullptr;
    place.asLeader([&] {
        json = outputs.add("--json", arguments.json);
        markdown = outputs.add("--markdown", arguments.markdown);
    });
    bool const tables = arguments.markdown && (arguments.table || arguments.each);
    insight::ReportOptions options =
        optionsOf(arguments, tables && !arguments.json && arguments.markdown == "-");
    std::vector<insight::LevelReport> reports;
    nlohmann::ordered_json entries = nlohmann::ordered_json::array();
    for (auto const& file : levels) {
        if (place.workers().stopped()) {
            break;
        }
        insight::LevelUnderTest const level(data.dataFor(file), file);
        options.step = [&](std::string const& what) { place.say(level.name() + ", " + what); };
        reports.push_back(insight::reportOn(level, options, place.workers()));
        if (!place.leads()) {
            continue;
        }
        entries.push_back(insight::toJson(reports.back()));
        place.clearProgress();
        if (!outputs.terminalTaken()) {
            std::cout << visibleLines(insight::toWords(reports.back())) << std::flush;
        }
    }
    place.clearProgress();
    if (!place.leads()) {
        return exitSolved;
    }
    if (json != nullptr) {
        json->stream() << escapedJson(
                              entries.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace))
                       << "\n";
    }
    if (markdown != nullptr) {
        markdown->stream() << (arguments.each       ? insight::toMarkdownRuns(reports)
                               : arguments.table    ? insight::toMarkdownTable(reports)
                               : arguments.sections ? insight::toMarkdownSections(reports)
                                                    : insight::toMarkdown(reports));
    }
    outputs.finish();
    if (place.workers().stopped()) {
        std::cerr << "trembler: stopped; the report has what was finished"
                  << (arguments.work.resume ? ", and the same command goes on from there" : "") << "\n";
    }
    bool const sound = std::all_of(reports.begin(), reports.end(), [](insight::LevelReport const& report) {
        return report.complete && insight::shortcomings(report).empty();
    });
    return sound ? exitSolved : exitNotSolved;
}

} // namespace

void addReportCommand(CLI::App& program, Work& work) {
    auto const arguments = std::make_shared<ReportArguments>();
    CLI::App* const command = program.add_subcommand(
        "report",
        "What levels' solutions need (by leaving parts, deeds and effects out and running again), how "
        "exactly "
        "their parts must be placed (by displacing them), of how many kinds they are, and what the effects "
        "cost. Exit status: 0 no level falls short of what is expected of a puzzle, 1 one does or the work "
        "was "
        "stopped, 2 bad input or output.");
    addLevels(*command, "LEVEL", arguments->paths,
              "Level files or folders (default: all levels, including those of the mods that come "
              "with the program)");
    addOptionalFile(*command, "--json", arguments->json, file_kinds::json,
                    "Write a JSON list with an object for each level; on the terminal it replaces the words");
    addOptionalFile(*command, "--markdown", arguments->markdown, file_kinds::markdown,
                    "Write tables, without times, so that they are the same on every machine");
    addNumber(*command, "--runs", arguments->runs, 0, 100'000, "Displaced runs of each solution")
        ->default_str("200");
    addNumber(*command, "--drops", arguments->drops, 0, 100'000,
              "Runs with each single part dropped at random")
        ->default_str("100");
    addNumber(*command, "--seed", arguments->seed, 0, 1'000'000'000, "Of the random displacements")
        ->default_str("1");
    addNumber(*command, "--jitter-cm", arguments->jitterCm, 0, 1000,
              "How far parts are displaced, in cm (default: 2)");
    addNumber(*command, "--jitter-degrees", arguments->jitterDegrees, 0, 180,
              "How far parts are turned, in degrees (default: 2)");
    addNumber(*command, "--jitter-seconds", arguments->jitterSeconds, 0, 60,
              "How much earlier or later deeds are done, in s (default: 0.1)");
    command->add_flag("--maps", arguments->maps, "Also where each part may lie, in steps of 5 cm");
    command->add_flag("--brief", arguments->brief, "Without costs and the cheapest detail levels");
    CLI::Option* const table =
        command->add_flag("--table", arguments->table, "Of --markdown only the table of all levels")
            ->needs("--markdown");
    CLI::Option* const sections =
        command->add_flag("--sections", arguments->sections, "Of --markdown only the sections of the levels")
            ->needs("--markdown")
            ->excludes(table);
    command
        ->add_flag("--each-run", arguments->each,
                   "Of --markdown only a table of the displaced and dropped runs: in which frame each of "
                   "them solved the level")
        ->needs("--markdown")
        ->excludes(table)
        ->excludes(sections);
    addNumber(*command, "--search", arguments->search, 0, 100'000'000,
              "Runs in search of other solutions, as `trembler solve` does")
        ->default_str("0");
    addWorkerOptions(*command, arguments->work);
    addModFolders(*command, arguments->mods);
    command->footer(outputConvention);
    command->callback([command, arguments, &work] {
        takeBack(*command, "LEVEL", arguments->paths, "--json", arguments->json);
        checkDisplacements(*arguments, command->count("--seed") > 0);
        work = [arguments] { return reportLevels(*arguments); };
    });
}

} // namespace trembler
