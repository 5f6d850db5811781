#include "puzzle/goals/conditions/circuit.hpp"

#include "physics/electricity/properties/electrical.hpp"
#include "puzzle/goals/judging/condition_state.hpp"
#include "puzzle/goals/reading/goal_reader.hpp"
#include "puzzle/goals/reading/schema_pieces.hpp"
#include "puzzle/goals/words/goal_text.hpp"

namespace trembler::conditions {

void CircuitCondition::read(JsonNode const& body, Condition& condition, GoalReader& reader) const {
    condition.subject = reader.selector(body);
}

nlohmann::ordered_json CircuitCondition::schema() const {
    return goal_schema::selector();
}

nlohmann::ordered_json CircuitCondition::draft(ConditionDraft const& with) const {
    return with.objects[0];
}

void CircuitCondition::begin(ConditionState& state, ObjectFinder const& finder, ObjectId /*it*/) const {
    finder.mustHave(state.condition().subject, propertyInfo<Conductor>(),
                    "is no conductor, so it is never on");
}

bool CircuitCondition::isOn(World const& world, ObjectId id) {
    auto const* const state = world.find<ElectricalState>();
    return state != nullptr && state->isOn(id);
}

void CircuitCondition::collectCauses(ConditionState const& state, World const& world, bool truth,
                                     std::vector<EventId>& events) const {
    auto const* const electrical = world.find<ElectricalState>();
    if (electrical == nullptr) {
        return;
    }
    for (ObjectId const id : state.subjects()) {
        if (electrical->isOn(id) == (on_ == truth)) {
            events.push_back(electrical->eventOf(id));
        }
    }
}

std::string CircuitCondition::phrase(Condition const& condition, GoalWords const& words, Mood mood,
                                     Noun const* it) const {
    Noun const who = words.noun(condition.subject, it);
    bool const wanted = on_ != (mood == Mood::avoid);
    bool const lamp = words.areLamps(condition.subject);
    if (mood == Mood::reach) {
        return words.speech().phrase(
            wanted ? (lamp ? "light {}" : "switch on {}") : (lamp ? "put out {}" : "switch off {}"), {who});
    }
    return words.speech().phrase(
        wanted ? (lamp ? "keep {} lit" : "keep {} on") : (lamp ? "keep {} dark" : "keep {} off"), {who});
}

} // namespace trembler::conditions
