// {"all": [conditions]}: all of them hold at the same time.
#include "puzzle/goals/checking/whole_level.hpp"
#include "puzzle/goals/conditions/kinds.hpp"
#include "puzzle/goals/conditions/list.hpp"
#include "puzzle/goals/judging/condition_state.hpp"
#include "puzzle/goals/words/goal_text.hpp"

#include <algorithm>

namespace trembler::conditions {
namespace {

/// The file's value at a place in the level's goals or its task; null if there is none.
nlohmann::json statement(LevelFile const& level, std::string const& path) {
    constexpr std::string_view goals = "/goals";
    constexpr std::string_view task = "/task";
    bool const inGoals = path.starts_with(goals);
    if (!inGoals && !path.starts_with(task)) {
        return {};
    }
    nlohmann::json const& tree = inGoals ? level.goals : level.task;
    nlohmann::json::json_pointer const at(path.substr((inGoals ? goals : task).size()));
    return tree.contains(at) ? tree.at(at) : nlohmann::json();
}

/// The condition that a statement negates, if it states nothing else; else null.
nlohmann::json onlyNegated(nlohmann::json const& stated) {
    std::string const key(negation().key());
    return stated.is_object() && stated.size() == 1 && stated.contains(key) ? stated[key] : nlohmann::json();
}

class AllCondition final : public ListCondition {
public:
    constexpr AllCondition() : ListCondition("all") {}

    [[nodiscard]] Standing judge(ConditionState& state, World const& /*world*/) const override {
        std::span<ConditionState const> const children = std::as_const(state).children();
        // Of one that must last, the time alone is progress (see ConditionState::update): some of its
        // conditions hold before the player has done anything.
        double const share =
            state.condition().seconds ? 0.0 : 1 / std::max(static_cast<double>(children.size()), 1.0);
        double progress = 0;
        for (ConditionState const& child : children) {
            progress += share * child.progress();
        }
        return {std::all_of(children.begin(), children.end(),
                            [](ConditionState const& child) { return child.met(); }),
                progress};
    }

    [[nodiscard]] bool needsAllChildren() const override { return true; }
    [[nodiscard]] bool listsGoals() const override { return true; }

    /// A condition and its opposite do not hold at the same time.
    [[nodiscard]] std::vector<Impossibility> whyHopeless(Condition const& condition,
                                                         WholeLevel const& level) const override {
        std::vector<Impossibility> reasons;
        for (Condition const& child : condition.children) {
            nlohmann::json const negated = onlyNegated(statement(level.level, child.path));
            bool const opposed =
                !negated.is_null() && std::any_of(condition.children.begin(), condition.children.end(),
                                                  [&](Condition const& other) {
                                                      return &other != &child &&
                                                             statement(level.level, other.path) == negated;
                                                  });
            if (opposed) {
                reasons.push_back({"another of these goals demands the opposite",
                                   "goals that can hold at the same time", child.path});
            }
        }
        return reasons;
    }

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
