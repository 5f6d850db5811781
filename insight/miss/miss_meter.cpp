#include "insight/miss/miss_meter.hpp"

#include "insight/miss/lift/lift.hpp"
#include "puzzle/goals/conditions/sequence.hpp"
#include "puzzle/goals/read_goals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace trembler::insight {

MissMeter::MissMeter(LevelFile const& level, World const& world, For what)
    : condition_(readGoals(level)), what_(what), ticks_(world.ticks()) {
    if (!condition_) {
        return;
    }
    Problems problems;
    ObjectFinder const finder(level, world, problems);
    state_ = std::make_unique<ConditionState>(*condition_, finder, ObjectId{});
    problems.throwIfAny();
    miss_ = std::make_unique<ConditionMiss>(*state_, world);
    split_ = splitsIntoGoals(*condition_);
    for (Condition const& goal : goalsOf(*condition_)) {
        GoalMiss made;
        made.id = goal.id.empty() ? fmt::format("goal {}", result_.goals.size() + 1) : goal.id;
        made.nearest.measure = 2; // anything is nearer
        result_.goals.push_back(std::move(made));
    }
    after_.resize(result_.goals.size());
    nearestCircuits_.resize(result_.goals.size());
    if (what_ == For::explanation) {
        circuits_.rememberWires(world);
    }
}

MissMeter::~MissMeter() = default;

ConditionMiss const& MissMeter::conditionOf(std::size_t goal) const {
    return split_ ? miss_->children()[goal] : *miss_;
}

void MissMeter::keepNearest(std::size_t goal, Miss miss, World const& world) {
    Miss& nearest = result_.goals[goal].nearest;
    nearest = std::move(miss);
    nearest.frame = world.frame();
    if (what_ == For::explanation) {
        addLift(nearest, world);
        after_[goal].end();
        if (nearest.lack == Lack::time) {
            double const frames = std::ceil(nearest.by / frameDuration);
            after_[goal].begin(conditionOf(goal), world.frame(), static_cast<std::uint64_t>(frames));
        }
    }
    nameObjects(nearest, world.store());
}

void MissMeter::lookAtCircuits(std::size_t goal, World const& world) {
    Circuits& circuits = nearestCircuits_[goal];
    if (auto const step = conditions::stepsDoneIfAny(conditionOf(goal).state())) {
        if (std::exchange(circuits.step, *step) != *step) {
            circuits.nearest.clear();
        }
    }
    circuits.nearest.look(world, circuits_);
}

GoalMiss MissMeter::explained(std::size_t goal) const {
    GoalMiss made = result_.goals.at(goal);
    nearestCircuits_[goal].nearest.judge(made.nearest, made.nearest.frame);
    std::vector<Miss> const ended = after_[goal].misses();
    made.nearest.besides.insert(made.nearest.besides.end(), ended.begin(), ended.end());
    insulators_.tell(made.nearest);
    return made;
}

void MissMeter::look(World const& world) {
    if (miss_ == nullptr || result_.measure <= 0) {
        return;
    }
    std::uint64_t const passed = world.ticks() - std::exchange(ticks_, world.ticks());
    state_->update(world, std::max<std::uint64_t>(passed, 1));
    if (what_ == For::explanation) {
        insulators_.look(world);
    }
    Miss const whole = miss_->now(world, circuits_);
    if (whole.measure < result_.measure) {
        result_.measure = whole.measure;
        result_.frame = world.frame();
    }
    for (std::size_t i = 0; i < result_.goals.size(); ++i) {
        GoalMiss& goal = result_.goals[i];
        if (goal.met) {
            continue;
        }
        bool const met = split_ ? condition_->kind->standingOf(*state_, i).holds : state_->met();
        after_[i].look(world, circuits_);
        if (what_ == For::explanation) {
            lookAtCircuits(i, world);
        }
        Miss now = split_ ? conditionOf(i).now(world, circuits_) : whole;
        if (met) {
            goal.met = world.frame();
            now.measure = 0;
            now.lack = Lack::nothing;
        }
        if (now.measure < goal.nearest.measure) {
            keepNearest(i, std::move(now), world);
        }
    }
}

} // namespace trembler::insight
