#include "audio/effect/properties/acoustics.hpp"
#include "game/app/budget_report.hpp"
#include "game/app/commands.hpp"
#include "game/app/mods/mods.hpp"
#include "game/app/options/files/inputs.hpp"
#include "game/app/options/run/run_arguments.hpp"
#include "game/app/options/run/solution_option.hpp"
#include "game/app/options/run/sound_option.hpp"
#include "game/app/options/run/watch_option.hpp"
#include "game/app/options/values/assignments.hpp"
#include "game/app/progress.hpp"
#include "insight/probe/plot.hpp"
#include "insight/probe/watch_table.hpp"
#include "physics/dynamics/properties/crowd.hpp"
#include "physics/dynamics/properties/settings.hpp"
#include "physics/electricity/analyses/spice.hpp"
#include "puzzle/checks/checked_level.hpp"
#include "puzzle/run/frame_account.hpp"
#include "runtime/file/visible_text.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/level/write/write_level.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>
#include <span>

namespace trembler {
namespace {

constexpr std::uint64_t usualFrames = 600;
constexpr std::uint64_t mostHashes = 1'000'000; // all are kept until they are printed

WorldOptions optionsOf(RunArguments const& arguments, Registry const& registry, LevelFile const& level) {
    WorldOptions options;
    options.threads = arguments.threads;
    options.trace = arguments.trace.has_value() || arguments.account.has_value();
    options.detail = detailOf(arguments.detail);
    // The level's own choices, unless the command line overrides them.
    options.detail.insert(level.detail.begin(), level.detail.end());
    options.periods = periodsOf(registry, arguments.periods);
    return options;
}

void setSubsteps(LevelFile& level, int substeps) {
    DynamicsSettings settings;
    if (auto const* const stated = level.world.find<DynamicsSettings>()) {
        settings = *stated;
    }
    settings.substeps = substeps;
    level.world.set(settings);
}

/// Registers every file that the run reads or may read.
void noteInputs(Outputs& outputs, RunArguments const& arguments, GameData const& gameData,
                LevelFile const& level) {
    readsAll(outputs, gameData);
    outputs.reads(arguments.level);
    if (!arguments.solution.empty() && level.findSolution(arguments.solution) == nullptr) {
        outputs.reads(arguments.solution);
    }
    std::vector<PropertySet const*> sets;
    auto const addAll = [&](std::span<LevelObject const> objects) {
        for (LevelObject const& object : objects) {
            sets.push_back(&object.properties);
            for (auto const& [piece, properties] : object.pieces) {
                sets.push_back(&properties);
            }
        }
    };
    for (PartDefinition const* part : gameData.parts.all()) {
        sets.push_back(&part->properties);
        addAll(part->objects);
    }
    addAll(level.objects);
    auto const folders = sampleFoldersOf(gameData, arguments.level);
    for (PropertySet const* const set : sets) {
        if (Sample const* const sample = set->find<Sample>()) {
            for (std::filesystem::path const& folder : folders) {
                outputs.reads(folder / sample->file);
            }
        }
    }
}

std::string jsonOf(RunReport const& report, budget::BudgetMode const* mode) {
    nlohmann::ordered_json all = toJson(report);
    if (mode != nullptr) {
        addBudget(all, *mode);
    }
    return escapedJson(all.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) + "\n";
}

/// Adds a callback to the run that writes the table of watched fields.
void watchWith(RunOptions& run, std::optional<watch::WatchTable>& table, Registry const& registry,
               RunArguments const& arguments, std::ostream& out) {
    run.enter = [&, others = run.enter](Session& session) {
        if (others) {
            others(session);
        }
        table.emplace(registry, session.world(), arguments.watch, arguments.every, out);
        table->look(session.world());
    };
    run.frame = [&, others = run.frame](World const& world) {
        if (others) {
            others(world);
        }
        table->look(world);
    };
}

/// Adds a callback to the run that collects the watched fields for a plot.
void plotWith(RunOptions& run, insight::Probes& probes, std::vector<Subscription>& wanted,
              Registry const& registry, RunArguments const& arguments) {
    run.enter = [&, others = run.enter](Session& session) {
        if (others) {
            others(session);
        }
        std::vector<watch::WatchedField> const fields = watch::watchedFields(registry);
        for (std::string const& what : arguments.watch) {
            probes.add(session.world(), fields, what);
            PropertyInfo const& property = *probes.watches().back().field().property;
            if (property.kind != PropertyKind::object) {
                wanted.push_back(session.world().want(property));
            }
        }
        probes.look(session.world(), 0);
    };
    run.frame = [&, others = run.frame](World const& world) {
        if (others) {
            others(world);
        }
        if (world.frame() % arguments.every == 0) {
            probes.look(world, world.frame());
        }
    };
}

/// Refuses a run whose hashes or sound would have no room, before it begins.
void checkLengths(RunArguments const& arguments, std::uint64_t frames) {
    if (arguments.hashEvery != 0 && frames / arguments.hashEvery > mostHashes) {
        throw std::invalid_argument(
            fmt::format("--hash-every {}: prints {} hashes in {} frames; expected at most {}",
                        arguments.hashEvery, frames / arguments.hashEvery, frames, mostHashes));
    }
    if (arguments.sound && frames > RunSound::mostFrames()) {
        throw std::invalid_argument(
            fmt::format("--sound {}: the run has {} frames; expected at most {}, as a .wav file has no room "
                        "for more",
                        *arguments.sound, frames, RunSound::mostFrames()));
    }
}

/// Reports the causes of long frames: bodies in one place before the first frame, and every frame that took
/// long.
void tellOfSlowness(RunOptions& run, Session const& session, Progress& progress) {
    Store const& store = session.world().store();
    if (auto const crowd = crowdedStart(store)) {
        std::cerr << "trembler: " << visible(inWords(*crowd, store.nameOf(crowd->body))) << std::endl;
    }
    run.slow = [&progress](SlowFrame const& slow) {
        progress.clear();
        std::cerr << "trembler: " << visible(inWords(slow)) << "\n";
    };
}

} // namespace

int runLevel(RunArguments const& arguments) {
    auto const data = gameDataFor(arguments.level, arguments.mods);
    GameData const& gameData = *data;
    LevelFile level = loadLevel(gameData.registry, arguments.level);
    if (arguments.substeps) {
        setSubsteps(level, *arguments.substeps);
    }
    WorldOptions options = optionsOf(arguments, gameData.registry, level);
    BuiltLevel built = checkPlayable(gameData.registry, gameData.parts, level, options);
    std::vector<std::string> const doubts = doubtsAbout(gameData.parts, level, built);
    std::optional<Solution> solution;
    if (!arguments.solution.empty()) {
        solution = solutionStated(gameData.registry, level, arguments.solution);
    }
    if (solution && arguments.budget && !solution->changes.empty()) {
        throw std::invalid_argument(
            "--budget: the solution was recorded with changes of its own; run it without "
            "--budget to repeat it");
    }
    Outputs outputs;
    noteInputs(outputs, arguments, gameData, level);
    OutputFile* const json = outputs.add("--json", arguments.json);
    OutputFile* const trace = outputs.add("--trace", arguments.trace);
    OutputFile* const account = outputs.add("--account", arguments.account);
    OutputFile* const spice = outputs.add("--export-spice", arguments.spice);
    OutputFile* const record = outputs.add("--record", arguments.record);
    OutputFile* const csv = outputs.add("--csv", arguments.csv);
    OutputFile* const svg = outputs.add("--svg", arguments.svg);
    outputs.claimFile("--sound", arguments.sound, "a file whose name ends in .wav");

    Session session(gameData.registry, gameData.parts,
                    ReadyLevel{std::move(level), std::move(options), std::move(built)});
    if (arguments.record) {
        if (auto const whyNot = session.whyNotRecorded()) {
            throw std::invalid_argument(fmt::format("--record {}: {}", *arguments.record, *whyNot));
        }
    }
    checkWatched(gameData.registry, session.world(), arguments.watch);
    RunOptions run;
    budget::BudgetMode mode(gameData.registry);
    if (arguments.budget) {
        mode.setBudget(1000 * *arguments.budget);
        run.before = [&mode](Session& running) { mode.beforeStep(running); };
    }
    run.frames = arguments.frames.value_or(usualFrames);
    if (solution) {
        session.load(*solution);
        if (solution->frames && !arguments.frames) {
            run.frames = static_cast<std::uint64_t>(*solution->frames);
        }
    }
    run.hashEvery = arguments.hashEvery;
    checkLengths(arguments, run.frames);
    run.trace = trace == nullptr ? nullptr : &trace->stream();
    Progress progress;
    run.progress = [&](std::uint64_t done) {
        progress.frames(done, run.frames);
        outputs.check(); // fail early: the remaining outputs would be useless
    };
    run.timer = FrameTimer(arguments.slowAfter.value_or(slowAfter));
    tellOfSlowness(run, session, progress);
    std::optional<RunSound> sound;
    if (arguments.sound) {
        sound.emplace(*arguments.sound, arguments.level, gameData, run);
    }
    std::optional<watch::WatchTable> table;
    if (csv != nullptr) {
        watchWith(run, table, gameData.registry, arguments, csv->stream());
    }
    insight::Probes probes;
    std::vector<Subscription> wanted;
    if (svg != nullptr) {
        plotWith(run, probes, wanted, gameData.registry, arguments);
    }
    RunReport report = trembler::run(session, arguments.level, run);
    progress.clear();
    report.warnings.insert(report.warnings.begin(), doubts.begin(), doubts.end());
    reportScriptMessages(gameData);
    if (table) {
        for (std::string const& sentence : table->withoutValue(session.world())) {
            std::cerr << "trembler: " << visible(sentence) << "\n";
        }
    }
    budget::BudgetMode const* const budgeted = arguments.budget ? &mode : nullptr;
    if (account != nullptr) {
        account->stream() << frameAccount(session);
    }
    // Circuits may come about while the level runs, so only now is it known whether there is a netlist.
    std::string const netlist =
        spice == nullptr ? "" : spiceNetlist(session.world().store(), session.level().title);
    bool const withoutNetlist = spice != nullptr && netlist.empty();
    if (withoutNetlist) {
        outputs.drop(*spice);
    } else if (spice != nullptr) {
        spice->stream() << netlist;
    }
    if (svg != nullptr) {
        svg->stream() << insight::plotAsSvg(session.level().title, probes.series(), report.frames);
    }
    if (record != nullptr) {
        record->stream() << escapedJson(writeSolution(session.record("recorded")).dump(2)) << "\n";
    }
    if (json != nullptr) {
        json->stream() << jsonOf(report, budgeted);
    }
    if (sound) {
        sound->finish();
    }
    outputs.finish();
    if (json == nullptr || !json->isStandardOutput()) {
        outputs.words() << toWords(report) << (budgeted != nullptr ? budgetInWords(*budgeted) : "");
    }
    if (withoutNetlist) {
        throw std::invalid_argument("--export-spice: the level has no circuit with a resistance, an EMF, a "
                                    "rated power or a fuse, so there are no voltages to compute");
    }
    return report.solved ? exitSolved : exitNotSolved;
}

} // namespace trembler
