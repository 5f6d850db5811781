// The base of the kinds "on" and "off".
#pragma once

#include "puzzle/goals/model/condition_kind.hpp"

namespace trembler::conditions {

/// A condition on whether an object is part of a working circuit: {KEY: O}.
class CircuitCondition : public ConditionKind {
public:
    /// `on`: true if the object must be part of a working circuit, false if it must not be.
    constexpr CircuitCondition(std::string_view key, bool on) : ConditionKind(key), on_(on) {}

    void read(JsonNode const& body, Condition& condition, GoalReader& reader) const final;
    [[nodiscard]] nlohmann::ordered_json schema() const final;
    [[nodiscard]] nlohmann::ordered_json draft(ConditionDraft const& with) const final;
    void begin(ConditionState& state, ObjectFinder const& finder, ObjectId it) const final;
    void collectCauses(ConditionState const& state, World const& world, bool truth,
                       std::vector<EventId>& events) const final;
    [[nodiscard]] std::string phrase(Condition const& condition, GoalWords const& words, Mood mood,
                                     Noun const* it) const final;

protected:
    [[nodiscard]] static bool isOn(World const& world, ObjectId id);

private:
    bool on_;
};

} // namespace trembler::conditions
