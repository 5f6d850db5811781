// {"all": [conditions]}: all of them hold at the same time.
#include "puzzle/goals/conditions/list.hpp"
#include "puzzle/goals/judging/condition_state.hpp"
#include "puzzle/goals/words/goal_text.hpp"

#include <algorithm>

namespace trembler::conditions {
namespace {

class AllCondition final : public ListCondition {
public:
    constexpr AllCondition() : ListCondition("all") {}

    [[nodiscard]] Standing judge(ConditionState& state, World const& /*world*/) const override {
        std::span<ConditionState const> const children = std::as_const(state).children();
        double progress = 0;
        for (ConditionState const& child : children) {
            progress += child.progress() / static_cast<double>(children.size());
        }
        return {std::all_of(children.begin(), children.end(),
                            [](ConditionState const& child) { return child.met(); }),
                progress};
    }

    [[nodiscard]] bool listsGoals() const override { return true; }

    /// The opposite of "both" is "either not the first or not the second" (De Morgan).
    [[nodiscard]] std::string phrase(Condition const& condition, GoalWords const& words, Mood mood,
                                     Noun const* it) const override {
        return joined(condition, words, mood, it, mood != Mood::avoid);
    }

    [[nodiscard]] std::string lastingPhrase(Condition const& condition, GoalWords const& words,
                                            Noun const* it, std::string const& duration) const override {
        std::string const together =
            words.speech().phrase(condition.children.size() == 2 ? ", both" : ", all of it");
        return phrase(condition, words, Mood::keep, it) + (isCompound(condition) ? together : "") + duration;
    }
};

} // namespace

ConditionKind const& all() {
    static AllCondition const kind;
    return kind;
}

} // namespace trembler::conditions
