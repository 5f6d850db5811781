// trembler run: runs a level without a window.
#include "game/app/commands.hpp"
#include "game/app/mods/mods.hpp"
#include "game/app/options/files/file_rules.hpp"
#include "game/app/options/run/run_arguments.hpp"
#include "game/app/options/run/solution_option.hpp"
#include "game/app/options/run/watch_option.hpp"
#include "game/app/options/values/assignments.hpp"
#include "game/app/options/values/number_options.hpp"
#include "runtime/level/json/limits.hpp"

#include <memory>

namespace trembler {

namespace {

/// Options about the table and the plot, of which none does anything without the others.
void checkTable(RunArguments const& arguments, bool everyStated) {
    bool const written = arguments.csv || arguments.svg;
    if (written && arguments.watch.empty()) {
        throw CLI::ValidationError(arguments.csv ? "--csv" : "--svg",
                                   "expected --watch OBJECT.FIELD as well, which names the values to write");
    }
    if (!written && !arguments.watch.empty()) {
        throw CLI::ValidationError(
            "--watch", "expected --csv FILE or --svg FILE as well, which names the file to write");
    }
    if (!written && everyStated) {
        throw CLI::ValidationError("--every",
                                   "expected --csv FILE or --svg FILE as well, whose rows it spaces");
    }
}

} // namespace

void addRunCommand(CLI::App& program, Work& work) {
    auto const arguments = std::make_shared<RunArguments>();
    CLI::App* const command = program.add_subcommand(
        "run", "Run a level without a window. Exit status: 0 solved, 1 not solved, 2 bad input or output.");
    addLevel(*command, arguments->level, "Level file (required)");
    addNumber(*command, "--frames", arguments->frames, 1, limits::frames,
              "Frames to run, 60 are one second (default: the solution's, else 600)");
    addSolution(*command, arguments->solution,
                "Name of a solution recorded in the level, or a file with one");
    addNumber(*command, "--threads", arguments->threads, 1, 256,
              "Number of threads; the result does not depend on it")
        ->default_str("1");
    addOptionalFile(*command, "--json", arguments->json, file_kinds::json,
                    "Write one JSON object; on the terminal it replaces the words");
    addFile(*command, "--trace", arguments->trace, file_kinds::jsonLines,
            "Write every event and its causes, one JSON line each");
    addFile(*command, "--account", arguments->account, file_kinds::markdown,
            "Write the changes of each frame, in the form of the thesis's accounts (Markdown)");
    addFile(*command, "--sound", arguments->sound, file_kinds::wav,
            "Write the sound to a .wav file, never to the terminal, as heard in front of the middle of the "
            "level; needs no sound device");
    addNumber(*command, "--hash-every", arguments->hashEvery, 1, limits::frames,
              "Also print the state's hash at every Nth frame");
    addDetail(*command, arguments->detail,
              "A detail level, for example electricity=single-cable or dynamics=chipmunk; `trembler "
              "components` lists them");
    addPeriod(*command, arguments->periods,
              "Run a component in every Nth frame only, for example \"Dynamics Resolver=2\"");
    addModFolders(*command, arguments->mods);
    addNumber(*command, "--substeps", arguments->substeps, 0, 64,
              "Steps of the dynamics engine in a frame; 0: as many as the scene needs");
    addFile(*command, "--export-spice", arguments->spice, file_kinds::netlist,
            "Write the circuits, as they are after the last frame, as a netlist for ngspice -b");
    addNumber(
        *command, "--budget", arguments->budget, 1e-3, 1e3,
        "Time budget in milliseconds per frame: detail levels and periods are chosen during the run so that "
        "the error is least; the choices depend on this computer's speed, so record them to repeat the run");
    addNumber(*command, "--slow", arguments->slowAfter, 0, 3600,
              "Tell of every frame that takes more processor time than that, in s")
        ->default_str("2");
    addFile(*command, "--record", arguments->record, file_kinds::json,
            "Write the run, with all inputs and changes, as a solution for --solution");
    addWatch(*command, arguments->watch,
             "A column of the table --csv, a line of the plot --svg, for example lamp.current, "
             "ball.position or "
             "world.gravity; elements of lists by number (ball.shape.0.radius), their number as count "
             "(world.contacts.current.count), components as .x and .y (world.gravity.y), the "
             "length of a vector as .length (ball.velocity.length). An unknown name is "
             "reported with similar names");
    addNumber(*command, "--every", arguments->every, 1, limits::frames,
              "Frames between rows of the table --csv, or points of the plot --svg")
        ->default_str("1");
    addFile(*command, "--csv", arguments->csv, file_kinds::csv,
            "Write the values that --watch names over time, as comma-separated values");
    addFile(*command, "--svg", arguments->svg, file_kinds::svg,
            "Plot the values that --watch names over time, as a picture");
    command->footer(outputConvention);
    command->callback([command, arguments, &work] {
        takeBack(*command, "LEVEL", arguments->level, "--json", arguments->json);
        checkTable(*arguments, command->count("--every") > 0);
        work = [arguments] { return runLevel(*arguments); };
    });
}

} // namespace trembler
