// {"not": condition}: the condition does not hold.
#include "puzzle/goals/conditions/kinds.hpp"
#include "puzzle/goals/conditions/moved.hpp"
#include "puzzle/goals/judging/condition_state.hpp"
#include "puzzle/goals/reading/goal_reader.hpp"
#include "puzzle/goals/reading/schema_pieces.hpp"
#include "puzzle/goals/words/goal_text.hpp"

namespace trembler::conditions {
namespace {

class NegationCondition final : public ConditionKind {
public:
    constexpr NegationCondition() : ConditionKind("not") {}

    void read(JsonNode const& body, Condition& condition, GoalReader& reader) const override {
        condition.children.push_back(reader.condition(body));
    }

    [[nodiscard]] nlohmann::ordered_json schema() const override { return goal_schema::condition(); }

    [[nodiscard]] nlohmann::ordered_json draft(ConditionDraft const& with) const override {
        return movedDraft(with);
    }

    [[nodiscard]] Standing judge(ConditionState& state, World const& /*world*/) const override {
        return {!state.children().empty() && !state.children().front().met(), 0};
    }

    void collectCauses(ConditionState const& state, World const& world, bool truth,
                       std::vector<EventId>& events) const override {
        for (ConditionState const& child : state.children()) {
            child.collectCauses(world, !truth, events);
        }
    }

    [[nodiscard]] std::string phrase(Condition const& condition, GoalWords const& words, Mood mood,
                                     Noun const* it) const override {
        return words.phrase(condition.children.front(), opposite(mood), it);
    }

    /// The negated condition may have several phrases.
    [[nodiscard]] bool isCompound(Condition const& /*condition*/) const override { return true; }
};

} // namespace

ConditionKind const& negation() {
    static NegationCondition const kind;
    return kind;
}

} // namespace trembler::conditions
