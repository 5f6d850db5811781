// trembler accuracy: what accuracy costs.
#include "game/accuracy/ladder.hpp"
#include "game/accuracy/plot.hpp"
#include "game/accuracy/report.hpp"
#include "game/app/commands.hpp"
#include "game/core/workshop.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <unistd.h>

namespace trembler {
namespace {

namespace fs = std::filesystem;

struct AccuracyArguments {
    std::vector<std::string> effects;
    std::string json;
    std::string plot;
    bool markdown = false;
    bool brief = false;
    int runs = 1;
};

void write(fs::path const& file, std::string const& text) {
    std::ofstream out(file, std::ios::binary);
    if (!(out << text) || !out.flush()) {
        throw std::runtime_error(fmt::format("{}: the file cannot be written", file.string()));
    }
}

// Where plots lie as seen from docs/, for the page that is made for it.
std::string fromDocs(std::string const& plot) {
    if (plot.empty()) {
        return "";
    }
    fs::path const path = fs::path(plot).lexically_normal();
    std::string text = path.generic_string();
    while (!text.empty() && text.back() == '/') {
        text.pop_back();
    }
    return text.starts_with("docs/") ? text.substr(5) : text;
}

int report(AccuracyArguments const& arguments) {
    Workshop const workshop;
    if (!arguments.plot.empty()) {
        std::error_code error;
        fs::create_directories(arguments.plot, error);
        if (!fs::is_directory(arguments.plot)) {
            throw std::invalid_argument(fmt::format("--plot {}: the folder cannot be made", arguments.plot));
        }
    }
    if (!arguments.json.empty() && arguments.json != "-") {
        write(arguments.json, ""); // rather now than after all the work
    }
    bool const watched = isatty(STDERR_FILENO) != 0;
    auto const ladders =
        accuracy::climb(workshop, arguments.effects, {.brief = arguments.brief, .runs = arguments.runs},
                        [&](std::string const& effect) {
                            if (watched) {
                                std::cerr << "\r" << effect << "                " << std::flush;
                            }
                        });
    if (watched) {
        std::cerr << "\r                            \r";
    }
    if (!arguments.plot.empty()) {
        for (accuracy::Ladder const& ladder : ladders) {
            write(fs::path(arguments.plot) / (accuracy::slugOf(ladder) + ".svg"), accuracy::asSvg(ladder));
        }
    }
    std::string const json = accuracy::asJson(ladders).dump(2) + "\n";
    if (arguments.json == "-") {
        std::cout << json;
        return exitSolved;
    }
    if (!arguments.json.empty()) {
        write(arguments.json, json);
    }
    std::cout << (arguments.markdown ? accuracy::asMarkdown(ladders, fromDocs(arguments.plot))
                                     : accuracy::asText(ladders));
    return exitSolved;
}

} // namespace

void addAccuracyCommand(CLI::App& program, int& result) {
    auto const arguments = std::make_shared<AccuracyArguments>();
    CLI::App* const command = program.add_subcommand(
        "accuracy", "Measure how far every detail level is off and what it costs, scene by scene");
    command->add_option("EFFECT", arguments->effects, "Effects, for example gravity (default: all)");
    command->add_option(
        "--json", arguments->json,
        "Write one JSON object to a file, or, with \"-\", to the terminal instead of the table");
    command->add_option("--plot,--out", arguments->plot,
                        "Folder for plots of the error over the time per frame, one SVG per ladder");
    command->add_flag("--markdown", arguments->markdown, "The table as the page docs/accuracy.md");
    command
        ->add_option(
            "--runs", arguments->runs,
            "Measure everything so many times and keep the least times, against what else the machine "
            "does (default: 1)")
        ->check(CLI::Range(1, 100));
    command->add_flag("--brief", arguments->brief, "Tiny scenes: a second in all, for trying it out");
    command->callback([arguments, &result] { result = guarded([&] { return report(*arguments); }); });
}

} // namespace trembler
