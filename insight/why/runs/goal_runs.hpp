// Runs that show whether a change would have brought a goal nearer.
#pragma once

#include "insight/run/variation.hpp"
#include "insight/why/answer.hpp"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace trembler::insight {

/// The result of one run for a goal.
struct GoalRun {
    bool met = false;
    /// It came clearly nearer than the run that was asked about: its measure is a tenth less, or it met the
    /// goal. False if the run was not possible.
    bool nearer = false;
    bool deviceWasOn = false; ///< whether current flowed through the device in any frame
    bool touched = false;     ///< whether both objects of each pair touched for longer than a bounce

    /// What the run showed about the goal.
    [[nodiscard]] IfClosed shown() const {
        return met ? IfClosed::met : nearer ? IfClosed::nearer : IfClosed::unknown;
    }
};

/// What is looked at in a run besides the goal.
struct GoalWatch {
    std::string device{}; ///< by name; empty: none
    std::vector<std::pair<std::string, std::string>> pairs{};
};

/// All referenced objects must outlive it.
class GoalRuns {
public:
    /// `measure`: that of the goal's nearest miss in the run that was asked about.
    GoalRuns(LevelRuns const& runs, std::string goal, double measure, AskOptions const& options,
             Answer& answer)
        : runs_(runs), goal_(std::move(goal)), measure_(measure), options_(options), answer_(answer) {}

    /// Side by side, and counted in the answer. Empty if it was stopped; then the answer is incomplete.
    [[nodiscard]] std::vector<GoalRun> run(std::vector<Variation> const& variations, GoalWatch const& watch);

private:
    [[nodiscard]] GoalRun one(Variation const& variation, GoalWatch const& watch) const;

    LevelRuns const& runs_;
    std::string goal_;
    double measure_;
    AskOptions const& options_;
    Answer& answer_;
};

/// Runs each variation, and adds what `missOf` says of it by its index, with what the run showed, to what
/// stands beside the answer's nearest miss, if the run came nearer to the goal. Does nothing without
/// variations.
void addWhatCameNearer(LevelRuns const& runs, AskOptions const& options, Answer& answer,
                       std::vector<Variation> const& variations,
                       std::function<Miss(std::size_t index)> const& missOf);

} // namespace trembler::insight
