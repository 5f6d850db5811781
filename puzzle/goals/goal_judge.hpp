// Observes a running world and reports which goals are met. Changes nothing in the world.
#pragma once

#include "puzzle/goals/judging/condition_state.hpp"
#include "puzzle/goals/model/condition.hpp"
#include "runtime/world/world.hpp"

#include <memory>

namespace trembler {

/// One goal as the player sees it. A level whose condition is "all" or a "sequence" has one goal for each
/// child of the condition, any other level has one.
struct GoalStatus {
    std::string id;                     ///< the stated id, else "goal 1", "goal 2" ...
    std::string text;                   ///< for the player
    bool met = false;                   ///< at present
    std::optional<std::uint64_t> frame; ///< in which it was met for the first time
    double progress = 0;                ///< 0 to 1
};

class GoalJudge {
public:
    /// Finds the objects of the goals in a world that buildWorld() made from the level, before its first
    /// frame. Throws InputError if the goals are wrong or can never be met, for example if a wooden object
    /// must be on, or an object without a shape must touch another.
    GoalJudge(LevelFile const& level, World const& world);
    /// The same for a condition of the level that is not under "goals", such as a demonstration's task.
    GoalJudge(LevelFile const& level, World const& world, std::optional<Condition> condition);
    ~GoalJudge();
    GoalJudge(GoalJudge const&) = delete;
    GoalJudge& operator=(GoalJudge const&) = delete;

    /// Reads the world. To be called after every part of a frame (World::step()), so that no state that lasts
    /// less than a frame is missed. The result depends on the world's data alone. Once the level is solved,
    /// the result no longer changes.
    void update(World const& world);

    [[nodiscard]] std::vector<GoalStatus> const& status() const { return status_; }
    /// Whether the whole condition has held in any frame so far. False for a level without goals.
    [[nodiscard]] bool solved() const { return solvedFrame_.has_value(); }
    [[nodiscard]] std::optional<std::uint64_t> solvedFrame() const { return solvedFrame_; }
    /// The goals that were met for the first time in the last update.
    [[nodiscard]] std::vector<std::size_t> const& newlyMet() const { return newlyMet_; }
    /// Whether the last update was the one in which the level was solved.
    [[nodiscard]] bool newlySolved() const { return newlySolved_; }

    /// The traced events that make a goal true (contacts, electrical states, magnetic forces), ascending. To
    /// be called directly after an update. Empty without a trace.
    [[nodiscard]] std::vector<EventId> causes(World const& world, std::size_t goal) const;
    /// The same for the condition as a whole.
    [[nodiscard]] std::vector<EventId> causes(World const& world) const;
    /// The objects that a goal is about, ascending.
    [[nodiscard]] std::vector<ObjectId> objects(std::size_t goal) const;

private:
    [[nodiscard]] ConditionState const& stateOf(std::size_t goal) const;

    std::optional<Condition> condition_;
    std::unique_ptr<ConditionState> state_; // of the condition as a whole
    bool split_ = false;                    // each child of the condition is a goal
    std::vector<GoalStatus> status_;
    std::vector<std::size_t> newlyMet_;
    std::optional<std::uint64_t> solvedFrame_;
    bool newlySolved_ = false;
    std::uint64_t ticks_ = 0; // of the world, at the last update
};

} // namespace trembler
