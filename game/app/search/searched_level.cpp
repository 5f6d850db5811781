#include "game/app/search/searched_level.hpp"

#include "game/app/search/found_files.hpp"
#include "insight/report/report_text.hpp"
#include "insight/search/recorded.hpp"
#include "runtime/file/visible_text.hpp"
#include "runtime/level/write/write_level.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <span>

namespace trembler {
namespace {

nlohmann::ordered_json countsOf(insight::SearchResult const& result) {
    nlohmann::ordered_json counts;
    counts["runs"] = result.runs;
    counts["solved_runs"] = result.solved;
    counts["first_solved_run"] =
        result.firstSolved ? nlohmann::ordered_json(*result.firstSolved) : nlohmann::ordered_json();
    counts["kinds"] = result.found.size();
    return counts;
}

nlohmann::ordered_json orNull(std::optional<double> value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

/// The seconds as the journal has them, or else as they were measured now, for the journal.
std::optional<double> secondsKept(std::string const& key, std::optional<double> measured,
                                  insight::Workers& workers) {
    std::string const text = measured ? fmt::format("{}", *measured) : std::string();
    auto const kept = workers.share(std::span(&key, 1), [&](std::size_t) { return text; });
    return kept.front() && !kept.front()->empty() ? std::optional(std::atof(kept.front()->c_str()))
                                                  : std::nullopt;
}

} // namespace

std::optional<double> SearchedLevel::runsPerSecond() const {
    return seconds ? std::optional(static_cast<double>(search.runs) / std::max(*seconds, 1e-9))
                   : std::nullopt;
}

std::string countsInWords(insight::SearchResult const& result) {
    return fmt::format("{} of {} runs solve it{}; {} kind{} of solutions", result.solved, result.runs,
                       result.firstSolved ? fmt::format(", the first one run {}", *result.firstSolved) : "",
                       result.found.size(), result.found.size() == 1 ? "" : "s");
}

SearchedLevel searchLevel(insight::LevelUnderTest const& level, std::filesystem::path const& file,
                          SolveArguments const& arguments, std::uint64_t runs, bool many, WorkPlace& place) {
    insight::Workers& workers = place.workers();
    SearchedLevel searched;
    searched.file = file;
    searched.name = level.name();
    insight::SearchOptions options;
    options.runs = runs;
    options.seed = arguments.seed;
    options.frames = arguments.frames;
    options.hands = !arguments.noHands;
    options.random = arguments.random;
    options.progress = [&](std::uint64_t done, std::size_t kinds) {
        place.say(
            fmt::format("{}{} runs, {} kinds of solutions", many ? level.name() + ": " : "", done, kinds));
    };
    double const begin = place.seconds();
    std::uint64_t const before = workers.done();
    searched.search = searchFor(level, options, workers);
    searched.seconds = place.seconds() - begin;
    bool const computed = workers.done() - before >= searched.search.runs;
    if (arguments.compare && !workers.stopped()) {
        options.random = true;
        options.runs = searched.search.runs;
        searched.chance = searchFor(level, options, workers);
    }
    searched.complete = !workers.stopped();
    if (many) {
        searched.seconds = computed ? searched.seconds : std::nullopt;
        if (searched.complete) {
            searched.seconds =
                secondsKept(fmt::format("seconds/{}/{}/{}/{}/{}/{}/{}/{}", level.identity(), arguments.seed,
                                        arguments.frames, runs, options.hands, arguments.random,
                                        workers.threads(), workers.team().size()),
                            searched.seconds, workers);
        }
    }
    return searched;
}

LevelSummary summaryOf(SearchedLevel const& searched, insight::LevelUnderTest const& level,
                       SolveArguments const& arguments, Outputs const& outputs, KeptInLevel* inLevel,
                       WorkPlace& place) {
    insight::SearchResult const& result = searched.search;
    insight::Workers own(
        {.threads = arguments.work.threads}); // not the team, whose other members do not report
    auto const recorded = recordedKinds(level, own);
    LevelSummary summary;
    nlohmann::ordered_json& all = summary.json;
    all["level"] = searched.name;
    all["seed"] = arguments.seed;
    all["complete"] = searched.complete;
    all.update(countsOf(result));
    all["places_of_interest"] = result.places;
    all["nearest_miss"] = {{"measure", result.nearest}, {"solution", writeSolution(result.nearestMiss)}};
    all["seconds"] = orNull(searched.seconds);
    all["runs_per_second"] = orNull(searched.runsPerSecond());
    all["threads"] = place.workers().threads();
    all["processes"] = place.workers().team().size();
    all["found"] = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < result.found.size(); ++i) {
        insight::FoundSolution const& found = result.found[i];
        std::string const as = recordedAs(recorded, found);
        nlohmann::ordered_json one = toJson(found);
        one["recorded_as"] = as.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(as);
        std::string line =
            fmt::format("  {}. {} (run {}, {} times{})", i + 1, inWords(found.graph), found.run, found.times,
                        as.empty() ? ", recorded by nobody" : fmt::format(", as '{}'", as));
        if (arguments.keep) {
            KeptFiles const kept =
                keepFound(level.data(), searched.file, found, i + 1, *arguments.keep, outputs);
            one["file"] = kept.solution.string();
            one["picture"] = kept.picture.empty() ? nlohmann::ordered_json()
                                                  : nlohmann::ordered_json(kept.picture.string());
            line += fmt::format("\n     {} {}", kept.solution.string(),
                                kept.picture.empty() ? "(no picture: " + kept.whyNoPicture + ")"
                                                     : kept.picture.string());
            if (!kept.otherName.empty()) {
                place.clearProgress();
                std::cerr << "trembler: --keep: " << visible(kept.otherName) << "; the solution is in "
                          << visible(kept.solution.string()) << "\n";
            }
        }
        if (inLevel != nullptr) {
            std::string const name = as.empty() ? inLevel->add(found, i + 1) : std::string();
            one["added_as"] = name.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(name);
            line += name.empty() ? "" : fmt::format("\n     added to the level as '{}'", name);
        }
        all["found"].push_back(std::move(one));
        summary.lines.push_back(std::move(line));
    }
    if (inLevel != nullptr) {
        inLevel->save();
    }
    if (searched.chance) {
        all["random"] = countsOf(*searched.chance);
    }
    return summary;
}

} // namespace trembler
