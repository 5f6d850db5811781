// trembler accuracy: measures the error and the cost of every detail level.
#include "game/app/commands.hpp"
#include "game/app/options/files/file_rules.hpp"
#include "game/app/options/files/inputs.hpp"
#include "game/app/options/files/outputs.hpp"
#include "game/app/options/values/number_options.hpp"
#include "game/app/progress.hpp"
#include "measure/accuracy/ladder.hpp"
#include "measure/accuracy/plot.hpp"
#include "measure/accuracy/report.hpp"
#include "puzzle/data/game_data.hpp"
#include "runtime/file/folders.hpp"
#include "runtime/file/visible_text.hpp"
#include "runtime/level/json/suggestion.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

namespace trembler {
namespace {

namespace fs = std::filesystem;

struct AccuracyArguments {
    std::vector<std::string> effects;
    OutputTarget json;
    OutputTarget markdown;
    std::optional<std::string> plot;
    bool brief = false;
    int runs = 1;
};

// Path of a plot relative to docs/measurements/, for links on the generated page.
std::string fromMeasurements(std::optional<std::string> const& plot) {
    if (!plot) {
        return "";
    }
    fs::path const path = fs::path(*plot).lexically_normal();
    std::string text = path.generic_string();
    while (!text.empty() && text.back() == '/') {
        text.pop_back();
    }
    return text.starts_with("docs/") ? "../" + text.substr(5) : text;
}

/// The effects that have ladders, each once.
std::vector<std::string> effectsMeasured() {
    std::vector<std::string> effects;
    for (accuracy::Plan const& plan : accuracy::plans()) {
        if (std::find(effects.begin(), effects.end(), plan.effect) == effects.end()) {
            effects.push_back(plan.effect);
        }
    }
    return effects;
}

int report(AccuracyArguments const& arguments) {
    GameData const gameData;
    Outputs outputs;
    readsAll(outputs, gameData);
    // Opened now, so that a bad path fails before the measurements.
    OutputFile* const json = outputs.add("--json", arguments.json);
    OutputFile* const markdown = outputs.add("--markdown", arguments.markdown);
    Progress progress;
    auto const ladders =
        accuracy::climb(gameData, arguments.effects, {.brief = arguments.brief, .runs = arguments.runs},
                        [&](std::string const& effect) { progress.say(effect); });
    progress.clear();
    if (arguments.plot) {
        makeFolder(*arguments.plot); // only now, so that an interrupted command leaves no empty folder
        for (accuracy::Ladder const& ladder : ladders) {
            std::string const file = fs::path(*arguments.plot) / (accuracy::slugOf(ladder) + ".svg");
            outputs.add("--plot", file)->stream() << accuracy::asSvg(ladder);
        }
    }
    if (json != nullptr) {
        json->stream() << escapedJson(accuracy::asJson(ladders).dump(2)) << "\n";
    }
    if (markdown != nullptr) {
        markdown->stream() << accuracy::asMarkdown(ladders, fromMeasurements(arguments.plot));
    }
    outputs.finish();
    if (!outputs.terminalTaken()) {
        std::cout << accuracy::asText(ladders);
    }
    return exitSolved;
}

} // namespace

void addAccuracyCommand(CLI::App& program, Work& work) {
    auto const arguments = std::make_shared<AccuracyArguments>();
    CLI::App* const command = program.add_subcommand(
        "accuracy", "Measure the error and the time of every detail level, scene by scene");
    accepts(command->add_option("EFFECT", arguments->effects, "Effects, for example gravity (default: all)")
                ->type_name(""),
            "one of the effects: " + listed(effectsMeasured()), [](std::string const& effect) {
                std::vector<std::string> const known = effectsMeasured();
                return std::find(known.begin(), known.end(), effect) != known.end()
                           ? std::nullopt
                           : Fault("there is no such effect" + didYouMean(effect, known));
            });
    addOptionalFile(*command, "--json", arguments->json, file_kinds::json,
                    "Write one JSON object; on the terminal it replaces the table");
    addOutputFolder(*command, "--plot,--out", arguments->plot,
                    "Folder for plots of the error over the time per frame, one SVG per ladder");
    addOptionalFile(*command, "--markdown", arguments->markdown, file_kinds::markdown,
                    "Write the page docs/measurements/accuracy.md; on the terminal it replaces the table");
    addNumber(*command, "--runs", arguments->runs, 1, 100,
              "Measure everything so many times and keep the least times, against what else the machine does "
              "(default: 1)");
    command->add_flag("--brief", arguments->brief, "Tiny scenes: a second in all, for trying it out");
    command->footer(outputConvention);
    command->callback([arguments, &work] { work = [arguments] { return report(*arguments); }; });
}

} // namespace trembler
