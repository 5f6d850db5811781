#include "puzzle/goals/model/condition_kind.hpp"

#include "puzzle/goals/judging/condition_state.hpp"
#include "puzzle/goals/words/goal_text.hpp"

namespace trembler {

std::optional<Impossibility> ConditionKind::whyNever(Condition const& /*condition*/,
                                                     CandidateFinder const& /*candidates*/) const {
    return std::nullopt;
}

std::vector<Impossibility> ConditionKind::whyHopeless(Condition const& /*condition*/,
                                                      WholeLevel const& /*level*/) const {
    return {};
}

void ConditionKind::begin(ConditionState& state, ObjectFinder const& finder, ObjectId it) const {
    state.addChildren(finder, it);
}

void ConditionKind::collectCauses(ConditionState const& state, World const& world, bool truth,
                                  std::vector<EventId>& events) const {
    for (ConditionState const& child : state.children()) {
        if (child.met() == truth) {
            child.collectCauses(world, truth, events);
        }
    }
}

Standing ConditionKind::standingOf(ConditionState const& state, std::size_t child) const {
    ConditionState const& goal = state.children()[child];
    return {goal.met(), goal.progress()};
}

int ConditionKind::countedSteps(Condition const& /*condition*/) const {
    return 0;
}

std::string ConditionKind::lastingPhrase(Condition const& condition, GoalWords const& words, Noun const* it,
                                         std::string const& duration) const {
    return phrase(condition, words, Mood::keep, it) + duration;
}

bool ConditionKind::isCompound(Condition const& /*condition*/) const {
    return false;
}

} // namespace trembler
