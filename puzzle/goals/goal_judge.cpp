#include "puzzle/goals/goal_judge.hpp"

#include "puzzle/goals/checking/never_holds.hpp"
#include "puzzle/goals/read_goals.hpp"
#include "puzzle/goals/words/goal_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace trembler {
namespace {

template <class T>
void makeUnique(std::vector<T>& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
}

} // namespace

GoalJudge::GoalJudge(LevelFile const& level, World const& world)
    : GoalJudge(level, world, readGoals(level)) {}

GoalJudge::GoalJudge(LevelFile const& level, World const& world, std::optional<Condition> condition)
    : condition_(std::move(condition)), ticks_(world.ticks()) {
    if (!condition_) {
        return;
    }
    Problems problems;
    ObjectFinder const finder(level, world, problems);
    state_ = std::make_unique<ConditionState>(*condition_, finder, ObjectId{});
    if (!finder.full()) {
        complainIfNever(*condition_, level, world, problems);
    }
    problems.throwIfAny();

    split_ = splitsIntoGoals(*condition_);
    GoalWords const words(world);
    for (Condition const& goal : goalsOf(*condition_)) {
        GoalStatus status;
        status.id = goal.id.empty() ? fmt::format("goal {}", status_.size() + 1) : goal.id;
        status.text = words.sentence(goal);
        status_.push_back(std::move(status));
    }
}

GoalJudge::~GoalJudge() = default;

ConditionState const& GoalJudge::stateOf(std::size_t goal) const {
    return split_ ? state_->children()[goal] : *state_;
}

void GoalJudge::update(World const& world) {
    newlyMet_.clear();
    newlySolved_ = false;
    if (!state_ || solvedFrame_) {
        return;
    }
    std::uint64_t const passed = world.ticks() - std::exchange(ticks_, world.ticks());
    state_->update(world, std::max<std::uint64_t>(passed, 1));
    for (std::size_t i = 0; i < status_.size(); ++i) {
        GoalStatus& status = status_[i];
        Standing const now =
            split_ ? condition_->kind->standingOf(*state_, i) : Standing{state_->met(), state_->progress()};
        status.met = now.holds;
        status.progress = now.holds ? 1 : now.progress;
        if (status.met && !status.frame) {
            status.frame = world.frame();
            newlyMet_.push_back(i);
        }
    }
    if (state_->met()) {
        solvedFrame_ = world.frame();
        newlySolved_ = true;
    }
}

std::vector<EventId> GoalJudge::causes(World const& world, std::size_t goal) const {
    std::vector<EventId> events;
    if (goal < status_.size()) {
        stateOf(goal).collectCauses(world, true, events);
    }
    makeUnique(events);
    return events;
}

std::vector<EventId> GoalJudge::causes(World const& world) const {
    std::vector<EventId> events;
    if (state_) {
        state_->collectCauses(world, true, events);
    }
    makeUnique(events);
    return events;
}

std::vector<ObjectId> GoalJudge::objects(std::size_t goal) const {
    std::vector<ObjectId> all;
    if (goal < status_.size()) {
        stateOf(goal).collectObjects(all);
    }
    makeUnique(all);
    return all;
}

} // namespace trembler
