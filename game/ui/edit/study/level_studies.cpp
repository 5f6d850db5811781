#include "game/ui/edit/study/level_studies.hpp"

#include <algorithm>
#include <utility>

namespace trembler::ui {
namespace {

using insight::LevelReport;
using insight::LevelUnderTest;
using insight::SearchResult;
using insight::Workers;

/// The session in the frame in which the reduced solution solves the level; nullptr if it cannot be played.
std::shared_ptr<Session const> momentOf(StudiedLevel const& of, insight::FoundSolution const& found) {
    try {
        auto session = std::make_shared<Session>(of.data->registry, of.data->parts, of.level);
        session->load(found.needs.least);
        for (std::uint64_t frame = 0; frame < found.needs.leastFrame; ++frame) {
            session->step();
        }
        return session;
    } catch (std::exception const&) { // it is listed without a picture
        return nullptr;
    }
}

/// Adds moments for the solutions found since, and shows them.
void showSearch(BackgroundWork<SearchShown>& work, StudiedLevel const& of, SearchShown& shown,
                SearchResult const& search) {
    shown.search = search;
    while (shown.moments.size() < search.found.size() && !work.stopAsked()) {
        shown.moments.push_back(momentOf(of, search.found[shown.moments.size()]));
    }
    work.show(shown);
}

} // namespace

template <class Result>
void LevelStudies::retire(Study<Result>& study) {
    if (study.work != nullptr) {
        study.work->stop();
        retired_.push_back(std::move(study.work));
    }
    study = {};
    std::erase_if(retired_, [](std::unique_ptr<AnyWork> const& work) { return !work->running(); });
}

void LevelStudies::makeReport(StudiedLevel level, std::string state) {
    retire(report_);
    retire(costs_);
    solution = noChoice;
    placement = 0;
    auto const of = std::make_shared<StudiedLevel const>(std::move(level));
    report_ = {of, std::move(state), nullptr};
    report_.work = std::make_unique<BackgroundWork<LevelReport>>(
        [of, options = reportOptions](BackgroundWork<LevelReport>& work) mutable {
            LevelUnderTest const tested(*of->data, of->level, of->name);
            Workers workers(work.workers());
            options.step = [&](std::string const& step) { work.say(step); };
            options.sofar = [&](LevelReport const& report) { work.show(report); };
            return reportOn(tested, options, workers);
        });
}

void LevelStudies::measureCosts(StudiedLevel level, std::string state) {
    retire(costs_);
    auto const of = std::make_shared<StudiedLevel const>(std::move(level));
    costs_ = {of, std::move(state), nullptr};
    costs_.work = std::make_unique<BackgroundWork<insight::LevelCosts>>(
        [of](BackgroundWork<insight::LevelCosts>& work) {
            LevelUnderTest const tested(*of->data, of->level, of->name);
            Workers workers(work.workers());
            work.say("what its effects cost");
            return costsOf(tested, workers);
        });
}

void LevelStudies::search(StudiedLevel level, std::string state, SearchRequest const& asked) {
    retire(search_);
    pictures.forget();
    runsAsked_ = static_cast<std::uint64_t>(asked.runs);
    insight::SearchOptions options;
    options.runs = runsAsked_;
    options.seed = static_cast<std::uint64_t>(asked.seed);
    options.hands = asked.hands;
    auto const of = std::make_shared<StudiedLevel const>(std::move(level));
    search_ = {of, std::move(state), nullptr};
    search_.work = std::make_unique<BackgroundWork<SearchShown>>(
        [of, options](BackgroundWork<SearchShown>& work) mutable {
            LevelUnderTest const tested(*of->data, of->level, of->name);
            Workers workers(work.workers());
            SearchShown shown{.of = of};
            work.say("what its solutions need");
            shown.recorded = recordedKinds(tested, workers);
            work.say("what else solves it");
            options.sofar = [&](SearchResult const& search) { showSearch(work, *of, shown, search); };
            shown.search = searchFor(tested, options, workers);
            shown.complete = !workers.stopped();
            return shown;
        });
}

bool LevelStudies::busy() const {
    return report_.running() || costs_.running() || search_.running();
}

void LevelStudies::forget() {
    retire(report_);
    retire(costs_);
    retire(search_);
    pictures.forget();
    solution = noChoice;
    placement = 0;
}

void LevelStudies::stopAll() {
    forget();
    retired_.clear();
}

} // namespace trembler::ui
