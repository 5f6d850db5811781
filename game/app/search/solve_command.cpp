// trembler solve: searches for solutions of a level.
#include "game/app/commands.hpp"
#include "game/app/mods/mods.hpp"
#include "game/app/options/inputs.hpp"
#include "game/app/options/number_options.hpp"
#include "game/app/options/outputs.hpp"
#include "game/app/search/found_files.hpp"
#include "game/app/search/worker_options.hpp"
#include "insight/report/report_text.hpp"
#include "insight/search/recorded.hpp"
#include "runtime/file/visible_text.hpp"
#include "runtime/level/write/write_level.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>
#include <limits>
#include <memory>

namespace trembler {
namespace {

struct SolveArguments {
    std::string level;
    std::vector<std::string> mods;
    OutputTarget json;
    std::optional<std::string> keep;
    WorkerArguments work;
    std::optional<std::uint64_t> runs;
    std::uint64_t seed = 1;
    std::uint64_t frames = 1200;
    bool noHands = false;
    bool random = false;
    bool compare = false;
};

constexpr std::uint64_t usualRuns = 2000;

nlohmann::ordered_json countsOf(insight::SearchResult const& result) {
    nlohmann::ordered_json counts;
    counts["runs"] = result.runs;
    counts["solved_runs"] = result.solved;
    counts["first_solved_run"] =
        result.firstSolved ? nlohmann::ordered_json(*result.firstSolved) : nlohmann::ordered_json();
    counts["kinds"] = result.found.size();
    return counts;
}

std::string countsInWords(insight::SearchResult const& result) {
    return fmt::format("{} of {} runs solve it{}; {} kind{} of solutions", result.solved, result.runs,
                       result.firstSolved ? fmt::format(", the first one run {}", *result.firstSolved) : "",
                       result.found.size(), result.found.size() == 1 ? "" : "s");
}

int solveLevel(SolveArguments const& arguments) {
    auto const data = gameDataFor(arguments.level, arguments.mods);
    Outputs outputs;
    readsAll(outputs, *data);
    outputs.reads(arguments.level);
    outputs.claimFile("--resume", arguments.work.resume.empty() ? OutputTarget() : arguments.work.resume,
                      "a file");
    if (arguments.keep) {
        checkFolderName("--keep", *arguments.keep);
    }
    insight::LevelUnderTest const level(*data, arguments.level);
    WorkPlace place(arguments.work);
    OutputFile* json = nullptr;
    place.asLeader([&] { json = outputs.add("--json", arguments.json); });
    insight::SearchOptions options;
    options.runs = arguments.runs.value_or(
        arguments.work.minutes ? std::numeric_limits<std::uint64_t>::max() / 2 : usualRuns);
    options.seed = arguments.seed;
    options.frames = arguments.frames;
    options.hands = !arguments.noHands;
    options.random = arguments.random;
    options.progress = [&](std::uint64_t runs, std::size_t kinds) {
        place.say(fmt::format("{} runs, {} kinds of solutions", runs, kinds));
    };
    insight::SearchResult const result = searchFor(level, options, place.workers());
    double const seconds = place.seconds();
    std::optional<insight::SearchResult> chance;
    if (arguments.compare && !place.workers().stopped()) {
        options.random = true;
        options.runs = result.runs;
        chance = searchFor(level, options, place.workers());
    }
    place.clearProgress();
    if (!place.leads()) {
        return exitSolved;
    }
    insight::Workers own({.threads = arguments.work.threads}); // not the team, whose others have ended
    auto const recorded = recordedKinds(level, own);
    bool const words = json == nullptr || !json->isStandardOutput();
    nlohmann::ordered_json all;
    all["level"] = level.name();
    all["seed"] = options.seed;
    all["complete"] = !place.workers().stopped();
    all.update(countsOf(result));
    all["places_of_interest"] = result.places;
    all["nearest_miss"] = {{"measure", result.nearest}, {"solution", writeSolution(result.nearestMiss)}};
    all["seconds"] = seconds;
    all["runs_per_second"] = seconds > 0 ? static_cast<double>(result.runs) / seconds : 0;
    all["threads"] = place.workers().threads();
    all["processes"] = place.workers().team().size();
    all["found"] = nlohmann::ordered_json::array();
    if (words) {
        outputs.words() << visible(level.name()) << ": " << countsInWords(result) << "\n";
    }
    for (std::size_t i = 0; i < result.found.size(); ++i) {
        insight::FoundSolution const& found = result.found[i];
        std::string const as = recordedAs(recorded, found);
        nlohmann::ordered_json one = toJson(found);
        one["recorded_as"] = as.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(as);
        std::string line =
            fmt::format("  {}. {} (run {}, {} times{})", i + 1, inWords(found.graph), found.run, found.times,
                        as.empty() ? ", recorded by nobody" : fmt::format(", as '{}'", as));
        if (arguments.keep) {
            KeptFiles const kept = keepFound(*data, arguments.level, found, i + 1, *arguments.keep);
            one["file"] = kept.solution.string();
            one["picture"] = kept.picture.empty() ? nlohmann::ordered_json()
                                                  : nlohmann::ordered_json(kept.picture.string());
            line += fmt::format("\n     {} {}", kept.solution.string(),
                                kept.picture.empty() ? "(no picture: " + kept.whyNoPicture + ")"
                                                     : kept.picture.string());
        }
        all["found"].push_back(std::move(one));
        if (words) {
            outputs.words() << visibleLines(line) << "\n";
        }
    }
    if (words && result.found.empty()) {
        outputs.words() << fmt::format("  the nearest miss: {:.3f}\n", result.nearest);
    }
    if (chance) {
        all["random"] = countsOf(*chance);
        if (words) {
            outputs.words() << "  placed at random: " << countsInWords(*chance) << "\n";
        }
    }
    if (words) {
        outputs.words() << fmt::format("  {:.1f} s, {:.0f} runs per second\n", seconds,
                                       static_cast<double>(result.runs) / std::max(seconds, 1e-9));
    }
    if (json != nullptr) {
        json->stream() << escapedJson(
                              all.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace))
                       << "\n";
    }
    outputs.finish();
    if (place.workers().stopped() && !arguments.work.minutes) {
        std::cerr << "trembler: stopped; this is what was found so far\n";
    }
    return result.found.empty() ? exitNotSolved : exitSolved;
}

} // namespace

void addSolveCommand(CLI::App& program, int& result) {
    auto const arguments = std::make_shared<SolveArguments>();
    CLI::App* const command = program.add_subcommand(
        "solve",
        "Search for solutions of a level: every part of the toolbox in every place of interest, then changes "
        "of the nearest misses, with simple things done by hand. One solution of each kind is reported, "
        "reduced to what it needs. Exit status: 0 found some, 1 none, 2 bad input or output.");
    command->add_option("LEVEL", arguments->level, "Level file (required)");
    addNumber(*command, "--runs", arguments->runs, 1, 100'000'000,
              "Runs to try (default: 2000, or as many as --minutes allows)");
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
    addOptionalFile(*command, "--json", arguments->json,
                    "Write one JSON object; on the terminal it replaces the words");
    command
        ->add_option_function<std::string>(
            "--keep", [arguments](std::string const& folder) { arguments->keep = folder; },
            "Write each found solution, for `trembler run --solution`, and a picture of it")
        ->type_name("DIR");
    addWorkerOptions(*command, arguments->work);
    addModFolders(*command, arguments->mods);
    command->footer(outputConvention);
    command->callback([arguments, &result] {
        takeBack(arguments->level, arguments->json, "LEVEL");
        result = guarded([&] { return solveLevel(*arguments); });
    });
}

} // namespace trembler
