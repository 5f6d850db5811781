// The base of the kinds "all", "any" and "sequence".
#pragma once

#include "puzzle/goals/model/condition_kind.hpp"

namespace trembler::conditions {

/// A condition that consists of other conditions: {KEY: [conditions]}.
class ListCondition : public ConditionKind {
public:
    explicit constexpr ListCondition(std::string_view key) : ConditionKind(key) {}

    void read(JsonNode const& body, Condition& condition, GoalReader& reader) const final;
    [[nodiscard]] nlohmann::ordered_json schema() const final;
    [[nodiscard]] nlohmann::ordered_json draft(ConditionDraft const& with) const final;
    /// True if there are several children and the level's author states no text.
    [[nodiscard]] bool isCompound(Condition const& condition) const final;

protected:
    /// The phrases of all children joined to one: "... and ..." if `conjunction`, else "either ... or ...".
    [[nodiscard]] static std::string joined(Condition const& condition, GoalWords const& words, Mood mood,
                                            Noun const* it, bool conjunction);
};

} // namespace trembler::conditions
