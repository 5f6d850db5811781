// {"sequence": [conditions]}: the conditions came true one after the other. Once all have, the sequence holds
// permanently.
//
// "First the bell, then the lamp" is not met by a lamp that was lit before: a step must begin to hold after
// the previous step was done. If it already holds when its turn comes, it must first cease to hold.
#include "puzzle/goals/conditions/sequence.hpp"

#include "puzzle/goals/conditions/kinds.hpp"
#include "puzzle/goals/conditions/list.hpp"
#include "puzzle/goals/judging/condition_state.hpp"
#include "puzzle/goals/words/goal_text.hpp"

#include <algorithm>

namespace trembler::conditions {
namespace {

/// The memory of a state.
struct Steps {
    std::size_t done = 0;
    bool blocked = false;        ///< the next step already held when its turn came, and has not ceased since
    std::vector<EventId> causes; ///< of the completed steps
};

class SequenceCondition final : public ListCondition {
public:
    constexpr SequenceCondition() : ListCondition("sequence") {}

    void begin(ConditionState& state, ObjectFinder const& finder, ObjectId it) const override {
        ConditionKind::begin(state, finder, it);
        state.remember(Steps{});
    }

    [[nodiscard]] Standing judge(ConditionState& state, World const& world) const override {
        std::span<ConditionState> const children = state.children();
        Steps& steps = state.memory<Steps>();
        if (steps.done < children.size()) {
            ConditionState const& step = children[steps.done];
            steps.blocked = steps.blocked && step.holds();
            if (!steps.blocked && step.met()) {
                step.collectCauses(world, true, steps.causes);
                ++steps.done;
                if (steps.done < children.size()) {
                    steps.blocked = children[steps.done].holds();
                    children[steps.done].restart();
                }
            }
        }
        double const now =
            steps.done < children.size() && !steps.blocked ? children[steps.done].progress() : 0;
        double const progress =
            (static_cast<double>(steps.done) + std::min(now, 1.0)) / static_cast<double>(children.size());
        return {steps.done == children.size(), progress};
    }

    void collectCauses(ConditionState const& state, World const& /*world*/, bool /*truth*/,
                       std::vector<EventId>& events) const override {
        Steps const& steps = state.memory<Steps>();
        events.insert(events.end(), steps.causes.begin(), steps.causes.end());
    }

    [[nodiscard]] bool listsGoals() const override { return true; }

    [[nodiscard]] int countedSteps(Condition const& condition) const override {
        return condition.children.size() > 1 ? static_cast<int>(condition.children.size()) : 0;
    }

    /// A step is done once it was met in its turn, not whenever its condition holds.
    [[nodiscard]] Standing standingOf(ConditionState const& state, std::size_t child) const override {
        std::size_t const done = state.memory<Steps>().done;
        return {child < done, child == done ? state.children()[child].progress() : 0};
    }

    [[nodiscard]] std::string phrase(Condition const& condition, GoalWords const& words, Mood mood,
                                     Noun const* it) const override {
        std::string text;
        for (std::size_t i = 0; i < condition.children.size(); ++i) {
            std::string const step = words.phrase(condition.children[i], Mood::reach, it);
            text += condition.children.size() == 1
                        ? step
                        : words.speech().phrase(i == 0 ? "first {}" : ", then {}", {{step}});
        }
        return mood == Mood::avoid ? words.speech().phrase("do not {}", {{text}}) : text;
    }

    /// A completed sequence stays completed, so afterwards the player only has to wait.
    [[nodiscard]] std::string lastingPhrase(Condition const& condition, GoalWords const& words,
                                            Noun const* it, std::string const& duration) const override {
        return phrase(condition, words, Mood::reach, it) + words.speech().phrase(", then wait") + duration;
    }
};

} // namespace

std::size_t stepsDone(ConditionState const& state) {
    return state.memory<Steps>().done;
}

std::optional<std::size_t> stepsDoneIfAny(ConditionState const& state) {
    bool const isSequence = dynamic_cast<SequenceCondition const*>(state.condition().kind) != nullptr;
    return isSequence ? std::optional(stepsDone(state)) : std::nullopt;
}

ConditionKind const& sequence() {
    static SequenceCondition const kind;
    return kind;
}

} // namespace trembler::conditions
