// trembler run: a level without a window.
#include "game/app/commands.hpp"
#include "game/budget/budget_mode.hpp"
#include "game/core/effects.hpp"
#include "game/core/workshop.hpp"
#include "game/session/runner.hpp"
#include "game/session/solution_file.hpp"
#include "physics/dynamics/settings.hpp"
#include "physics/electricity/spice.hpp"
#include "runtime/level/read_level.hpp"
#include "runtime/level/write_level.hpp"
#ifndef TREMBLER_HEADLESS
#include "game/ui/run_sound.hpp"
#endif

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iostream>
#include <memory>
#include <unistd.h>

namespace trembler {
namespace {

struct RunArguments {
    std::string level;
    std::optional<std::uint64_t> frames;
    std::string solution;
    int threads = 1;
    bool json = false;
    std::string trace;
    std::uint64_t hashEvery = 0;
    std::vector<std::string> detail;
    std::vector<std::string> periods;
    std::optional<int> substeps;
    std::string sound;
    std::string spice;
    std::optional<double> budget; // ms
    std::string record;
};

#ifdef TREMBLER_HEADLESS

/// Stands in for ui::RunSound.
class RunSound {
public:
    RunSound(std::string const&, std::string const&, Workshop const&, RunOptions&) {
        throw std::runtime_error("--sound: this build was made without sound; build it without "
                                 "-DTREMBLER_HEADLESS=ON");
    }
    void finish() {}
};

#else

class RunSound {
public:
    RunSound(std::string const& file, std::string const& level, Workshop const& workshop, RunOptions& run)
        : sound_(
              file, {.synthesiser = {}, .output = {}, .sampleFolders = ui::sampleFolders(workshop, level)},
              [](std::string const& what) { std::cerr << "trembler: " << what << "\n"; }, run) {}
    void finish() { sound_.finish(); }

private:
    ui::RunSound sound_;
};

#endif

int asPeriod(std::string const& text, std::string const& value) {
    std::size_t used = 0;
    int period = 0;
    try {
        period = std::stoi(value, &used);
    } catch (std::exception const&) {
        used = 0;
    }
    if (used != value.size()) {
        throw std::invalid_argument(
            fmt::format("--period {}: expected COMPONENT=N with a whole number N", text));
    }
    return period;
}

std::function<void(std::uint64_t)> progressOf(std::uint64_t frames) {
    if (isatty(STDERR_FILENO) == 0) {
        return {};
    }
    return [frames, next = std::uint64_t{600}](std::uint64_t done) mutable {
        if (done >= next) {
            std::cerr << fmt::format("\r{} of {} frames", done, frames) << std::flush;
            next += 600;
        }
        if (done == frames && frames >= 600) {
            std::cerr << "\r                              \r";
        }
    };
}

// The circuits as they are when the run is over.
void exportSpice(Session const& session, std::string const& path) {
#ifdef TREMBLER_WITHOUT_ELECTRICITY
    throw std::runtime_error(fmt::format("--export-spice {}: this program was built without electricity ({})",
                                         path, session.level().title));
#else
    std::string const netlist = spiceNetlist(session.world().store(), session.level().title);
    if (netlist.empty()) {
        throw std::invalid_argument(
            fmt::format("--export-spice {}: the level has no circuit with a resistance, "
                        "an EMF, a rated power or a fuse, so there are no volts to "
                        "compute",
                        path));
    }
    std::ofstream file(path);
    file << netlist;
    if (!file.flush()) {
        throw std::runtime_error(fmt::format("--export-spice {}: the file cannot be written", path));
    }
#endif
}

void addBudget(nlohmann::ordered_json& all, budget::BudgetMode const& mode) {
    nlohmann::ordered_json decisions = nlohmann::ordered_json::array();
    for (budget::Decision const& decision : mode.decisions()) {
        decisions.push_back({{"frame", decision.frame},
                             {"effect", decision.effect},
                             {"from", decision.from},
                             {"to", decision.to},
                             {"saves_us", decision.microseconds},
                             {"error", decision.error.share},
                             {"error_unit", decision.of},
                             {"error_m", decision.error.metres}});
    }
    all["budget"] = {{"budget_us", *mode.budget()},
                     {"last_round_us", mode.figures().microseconds},
                     {"slowest_frame_us", mode.figures().worst},
                     {"kept", mode.kept()},
                     {"hopeless", mode.hopeless()},
                     {"error_m", mode.error()},
                     {"decisions", decisions}};
}

std::string budgetInWords(budget::BudgetMode const& mode) {
    std::string text;
    for (budget::Decision const& decision : mode.decisions()) {
        text += fmt::format("  frame {:>6}  {}\n", decision.frame, inWords(decision));
    }
    return text + fmt::format(
                      "  budget {:.3g} ms, last second {:.3g} ms per frame{}; estimated error {:.2g} m after "
                      "a second\n",
                      *mode.budget() / 1000, mode.figures().microseconds / 1000,
                      mode.kept()       ? ""
                      : mode.hopeless() ? ": nothing that would do is cheap enough"
                                        : ": more than that",
                      mode.error());
}

void writeRecord(Session const& session, std::string const& path) {
    std::ofstream file(path);
    file << writeSolution(session.record("recorded")).dump(2) << "\n";
    if (!file.flush()) {
        throw std::runtime_error(fmt::format("--record {}: the file cannot be written", path));
    }
}

int runLevel(RunArguments const& arguments) {
    Workshop const workshop;
    LevelFile level = loadLevel(workshop.registry, arguments.level);
    if (arguments.substeps) {
        DynamicsSettings settings;
        if (auto const* const stated = level.world.find<DynamicsSettings>()) {
            settings = *stated;
        }
        settings.substeps = *arguments.substeps;
        level.world.set(settings);
    }
    WorldOptions options;
    options.threads = arguments.threads;
    options.trace = !arguments.trace.empty();
    options.detail = detailOf(arguments.detail);
    options.detail.insert(level.detail.begin(), level.detail.end()); // what it asks for and nobody overrules
    for (std::string const& text : arguments.periods) {
        auto const [component, value] = assignment(text, "--period", "COMPONENT=N");
        options.periods[component] = asPeriod(text, value);
    }
    std::optional<Solution> solution;
    if (!arguments.solution.empty()) {
        solution = findOrLoadSolution(workshop.registry, level, arguments.solution);
    }
    if (solution && arguments.budget && !solution->changes.empty()) {
        throw std::invalid_argument(
            "--budget: the solution was recorded with changes of its own; run it without "
            "--budget to repeat it");
    }
    if (!arguments.record.empty() &&
        !std::ofstream(arguments.record, std::ios::app)) { // before the work is done
        throw std::invalid_argument(fmt::format("--record {}: the file cannot be written", arguments.record));
    }
    Session session(workshop.registry, workshop.parts, std::move(level), options);
    RunOptions run;
    budget::BudgetMode mode(workshop.registry);
    if (arguments.budget) {
        mode.setBudget(1000 * *arguments.budget);
        run.before = [&mode](Session& running) { mode.beforeStep(running); };
    }
    run.frames = arguments.frames.value_or(600);
    if (solution) {
        session.load(*solution);
        if (solution->frames && !arguments.frames) {
            run.frames = static_cast<std::uint64_t>(*solution->frames);
        }
    }
    run.hashEvery = arguments.hashEvery;
    run.progress = progressOf(run.frames);
    std::ofstream trace;
    if (!arguments.trace.empty()) {
        trace.open(arguments.trace);
        if (!trace) {
            throw std::invalid_argument(
                fmt::format("--trace {}: the file cannot be written", arguments.trace));
        }
        run.trace = &trace;
    }
    std::optional<RunSound> sound;
    if (!arguments.sound.empty()) {
        if (gameEffectsLeftOut().contains("sound")) {
            throw std::invalid_argument("--sound: this build was made without the effect sound");
        }
        sound.emplace(arguments.sound, arguments.level, workshop, run);
    }
    RunReport const report = trembler::run(session, arguments.level, run);
    if (sound) {
        sound->finish();
    }
    if (!arguments.trace.empty() && !trace.flush()) {
        throw std::runtime_error(
            fmt::format("--trace {}: writing failed, the account is not complete", arguments.trace));
    }
    if (!arguments.spice.empty()) {
        exportSpice(session, arguments.spice);
    }
    if (!arguments.record.empty()) {
        writeRecord(session, arguments.record);
    }
    if (arguments.json) {
        nlohmann::ordered_json all = toJson(report);
        if (arguments.budget) {
            addBudget(all, mode);
        }
        std::cout << all.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << "\n";
    } else {
        std::cout << toWords(report);
        if (arguments.budget) {
            std::cout << budgetInWords(mode);
        }
    }
    return report.solved ? exitSolved : exitNotSolved;
}

} // namespace

void addRunCommand(CLI::App& program, int& result) {
    auto const arguments = std::make_shared<RunArguments>();
    CLI::App* const command = program.add_subcommand(
        "run", "Run a level without a window. Exit status: 0 solved, 1 not solved, 2 bad input.");
    command->add_option("LEVEL", arguments->level, "Level file")->required();
    command
        ->add_option("--frames", arguments->frames,
                     "Frames to run, 60 are one second (default: the solution's, "
                     "else 600)")
        ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{60'000'000}));
    command->add_option("--solution", arguments->solution,
                        "Name of a solution recorded in the level, or a file with one");
    command->add_option("--threads", arguments->threads, "Threads; the result never depends on them")
        ->check(CLI::Range(1, 256))
        ->capture_default_str();
    command->add_flag("--json", arguments->json, "Print one JSON object instead of words");
    command->add_option("--trace", arguments->trace,
                        "Write every event and its causes to a file, one JSON line each");
    command->add_option(
        "--sound", arguments->sound,
        "Write what it sounds like to a .wav file, as heard in front of the middle of the level; "
        "needs no sound device");
    command->add_option("--hash-every", arguments->hashEvery,
                        "Also print the state's hash at every Nth frame");
    command
        ->add_option("--detail", arguments->detail,
                     "EFFECT=LEVEL, for example electricity=single-cable or dynamics=chipmunk; `trembler "
                     "components` lists them")
        ->allow_extra_args(false); // the level may follow
    command
        ->add_option(
            "--period", arguments->periods,
            "COMPONENT=N: run a component in every Nth frame only, for example \"Dynamics Resolver=2\"")
        ->allow_extra_args(false);
    command
        ->add_option("--substeps", arguments->substeps,
                     "Steps of the dynamics engine in a frame; 0: as many as the scene needs")
        ->check(CLI::Range(0, 64));
    command->add_option("--export-spice", arguments->spice,
                        "Write the circuits, as they are after the last frame, as a netlist for ngspice -b");
    command
        ->add_option(
            "--budget", arguments->budget,
            "Milliseconds per frame: levels and periods are chosen, while it runs, so that the error is "
            "least; the choices depend on this computer's speed, so record them to repeat the run")
        ->check(CLI::Range(1e-3, 1e3));
    command->add_option("--record", arguments->record,
                        "Write the run, with all that was changed in it, as a solution for --solution");
    command->callback([arguments, &result] { result = guarded([&] { return runLevel(*arguments); }); });
}

} // namespace trembler
