// The analyses of the edited level that run in the background: report, costs of effects, search for
// solutions.
#pragma once

#include "game/ui/edit/study/background_work.hpp"
#include "game/ui/edit/study/found_pictures.hpp"
#include "insight/report/level_report.hpp"
#include "insight/search/recorded.hpp"
#include "puzzle/data/game_data.hpp"
#include "puzzle/session/session.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace trembler::ui {

/// A level as it stood when something was asked about it.
struct StudiedLevel {
    std::shared_ptr<GameData const> data;
    LevelFile level;
    std::string name;
    std::map<std::string, std::string> goals{}; ///< by id, as sentences in the player's language
};

/// A search as it is shown.
struct SearchShown {
    std::shared_ptr<StudiedLevel const> of{}; ///< the first member: the moments need its data until their end
    insight::SearchResult search = {};
    std::vector<insight::RecordedKind> recorded = {};
    /// By index in search.found: the moment in which it solves the level; nullptr if it cannot be played.
    std::vector<std::shared_ptr<Session const>> moments = {};
    bool complete = false; ///< all runs were made
};

/// Work on a level, and the level.
template <class Result>
struct Study {
    std::shared_ptr<StudiedLevel const> of;
    std::string state{}; ///< of the document, to find out whether it has changed since
    std::unique_ptr<BackgroundWork<Result>> work;

    [[nodiscard]] bool running() const { return work != nullptr && work->running(); }
    [[nodiscard]] std::shared_ptr<Result const> result() const {
        return work == nullptr ? nullptr : work->result();
    }
};

struct SearchRequest {
    double runs = 2000;
    double seed = 1;
    bool hands = true;
};

/// Texts of a state of the document, see actions::stateOf().
struct StateTexts {
    std::optional<std::uint64_t> revision;
    std::string whole;
    std::string withoutSolutions;
};

/// Window thread only. Nothing but the destructor and stopAll() waits for work.
class LevelStudies {
public:
    LevelStudies() = default;
    ~LevelStudies() { stopAll(); }
    LevelStudies(LevelStudies const&) = delete;
    LevelStudies& operator=(LevelStudies const&) = delete;

    // Each ends the former work of its kind.
    void makeReport(StudiedLevel level, std::string state);
    void measureCosts(StudiedLevel level, std::string state);
    void search(StudiedLevel level, std::string state, SearchRequest const& request);

    [[nodiscard]] Study<insight::LevelReport> const& report() const { return report_; }
    [[nodiscard]] Study<insight::LevelCosts> const& costs() const { return costs_; }
    [[nodiscard]] Study<SearchShown> const& searched() const { return search_; }
    /// How many runs the last search was to make.
    [[nodiscard]] std::uint64_t runsAsked() const { return runsAsked_; }
    /// Whether anything is being computed: pictures change by themselves then.
    [[nodiscard]] bool busy() const;
    /// Stops and forgets everything, without waiting: another level is edited.
    void forget();
    /// Stops everything and waits until it has ended.
    void stopAll();

    insight::ReportOptions reportOptions{.maps = true, .costs = false}; ///< of the next report
    SearchRequest request;                                              ///< of the next search
    std::size_t solution = noChoice;                                    ///< the chosen one of the report
    std::size_t placement = 0;                                          ///< its part whose places are shown
    FoundPictures pictures;                                             ///< of the last search
    StateTexts stateTexts;
    static constexpr std::size_t noChoice = static_cast<std::size_t>(-1);

private:
    template <class Result>
    void retire(Study<Result>& study);

    Study<insight::LevelReport> report_;
    Study<insight::LevelCosts> costs_;
    Study<SearchShown> search_;
    std::uint64_t runsAsked_ = 0;
    std::vector<std::unique_ptr<AnyWork>> retired_; // stopped, not ended yet
};

} // namespace trembler::ui
