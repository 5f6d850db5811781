// {"any": [conditions]}: at least one of them holds.
#include "puzzle/goals/conditions/kinds.hpp"
#include "puzzle/goals/conditions/list.hpp"
#include "puzzle/goals/judging/condition_state.hpp"
#include "puzzle/goals/words/goal_text.hpp"

#include <algorithm>

namespace trembler::conditions {
namespace {

class AnyCondition final : public ListCondition {
public:
    constexpr AnyCondition() : ListCondition("any") {}

    [[nodiscard]] Standing judge(ConditionState& state, World const& /*world*/) const override {
        Standing standing;
        for (ConditionState const& child : state.children()) {
            standing.holds = standing.holds || child.met();
            standing.progress = std::max(standing.progress, child.progress());
        }
        return standing;
    }

    /// The opposite of "either" is "not the first and not the second" (De Morgan).
    [[nodiscard]] std::string phrase(Condition const& condition, GoalWords const& words, Mood mood,
                                     Noun const* it) const override {
        return joined(condition, words, mood, it, mood == Mood::avoid);
    }

    [[nodiscard]] std::string lastingPhrase(Condition const& condition, GoalWords const& words,
                                            Noun const* it, std::string const& duration) const override {
        std::string const either = words.speech().phrase(", either of it");
        return phrase(condition, words, Mood::keep, it) + (isCompound(condition) ? either : "") + duration;
    }
};

} // namespace

ConditionKind const& any() {
    static AnyCondition const kind;
    return kind;
}

} // namespace trembler::conditions
