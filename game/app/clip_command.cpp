// trembler clip: a moving picture of a run.
#include "game/app/commands.hpp"
#include "game/app/mods/mods.hpp"
#include "game/app/options/files/file_rules.hpp"
#include "game/app/options/files/outputs.hpp"
#include "game/app/options/run/solution_option.hpp"
#include "game/app/options/values/number_options.hpp"
#include "game/app/options/values/picture_size.hpp"
#include "game/app/progress.hpp"
#include "runtime/level/json/limits.hpp"

#ifndef TREMBLER_HEADLESS
#include "game/app/options/files/inputs.hpp"
#include "game/ui/headless/clip.hpp"
#endif

#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <unistd.h>
#include <vector>

namespace trembler {
namespace {

struct ClipArguments {
    std::string level;
    OutputTarget out;
    std::string solution;
    std::string size = "960x540";
    std::optional<double> from;    // s
    std::optional<double> seconds; // s
    int rate = 30;
    bool electricity = false;
    bool forces = false;
    std::vector<std::string> mods; // folders in which mods are looked for
};

#ifdef TREMBLER_HEADLESS

int makeClip(ClipArguments const&) {
    throw std::runtime_error("this build was made without drawing; build it without -DTREMBLER_HEADLESS=ON");
}

#else

int makeClip(ClipArguments const& arguments) {
    auto const data = gameDataFor(arguments.level, arguments.mods);
    ui::ClipOptions options;
    PictureSize const size = *pictureSizeFrom(arguments.size); // checked with the other options
    options.size = {size.width, size.height};
    options.from = arguments.from.value_or(options.from);
    options.seconds = arguments.seconds.value_or(options.seconds);
    options.rate = arguments.rate;
    options.overlays.electricity = arguments.electricity;
    options.overlays.forces = arguments.forces;
    auto const session = sessionStated(*data, arguments.level, arguments.solution);
    Outputs outputs;
    readsAll(outputs, *data);
    outputs.reads(arguments.level);
    outputs.reads(arguments.solution);
    OutputFile* const file = outputs.add("--out", arguments.out, OutputFile::Content::binary);
    if (file->isStandardOutput() && isatty(STDOUT_FILENO) != 0) {
        throw OutputError("--out -: a terminal shows no pictures; expected a file, or standard output that "
                          "goes to another program");
    }
    Progress progress;
    options.progress = [&](std::uint64_t done, std::uint64_t of) { progress.frames(done, of); };
    ui::writeClip(*session, options, *file);
    progress.clear();
    outputs.finish();
    if (!file->isStandardOutput()) {
        std::cout << file->target().string() << "\n";
    }
    return exitSolved;
}

#endif

} // namespace

void addClipCommand(CLI::App& program, Work& work) {
    auto const arguments = std::make_shared<ClipArguments>();
    CLI::App* const command = program.add_subcommand(
        "clip", "Write a moving picture of a run, an animated WebP without interface; needs no display");
    addLevel(*command, arguments->level, "Level file")->required();
    addSolution(*command, arguments->solution,
                "Recorded solution, by name or file (default: the level runs as it begins)");
    addFile(*command, "--out", arguments->out, file_kinds::webp, "The WebP file to write")->required();
    addPictureSize(*command, arguments->size);
    constexpr double longest = static_cast<double>(limits::frames) / 60;
    addNumber(*command, "--from", arguments->from, 0.0, longest, "Seconds of the world before the clip")
        ->default_str("0");
    addNumber(*command, "--seconds", arguments->seconds, 0.1, 600.0, "How long the clip is, in seconds")
        ->default_str("8");
    addNumber(*command, "--rate", arguments->rate, 1, 60, "Pictures per second")->default_str("30");
    addModFolders(*command, arguments->mods);
    command->add_flag("--electricity", arguments->electricity, "Also draw the electricity graph");
    command->add_flag("--forces", arguments->forces, "With magnetic forces");
    command->footer(
        std::string("For example, six seconds of a recorded solution after its first second:\n"
                    "  trembler clip levels/first/1-first-contact.json --solution NAME --from 1 "
                    "--seconds 6 --out it.webp\n"
                    "The names of a level's solutions are in its file, under \"solutions\".\n\n") +
        outputConvention);
    command->callback([arguments, &work] { work = [arguments] { return makeClip(*arguments); }; });
}

} // namespace trembler
