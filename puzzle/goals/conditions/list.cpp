#include "puzzle/goals/conditions/list.hpp"

#include "puzzle/goals/conditions/moved.hpp"
#include "puzzle/goals/reading/goal_reader.hpp"
#include "puzzle/goals/reading/schema_pieces.hpp"
#include "puzzle/goals/words/english.hpp"
#include "puzzle/goals/words/goal_text.hpp"
#include "runtime/level/json/limits.hpp"

namespace trembler::conditions {

void ListCondition::read(JsonNode const& body, Condition& condition, GoalReader& reader) const {
    condition.children = reader.conditions(body);
}

nlohmann::ordered_json ListCondition::schema() const {
    return goal_schema::listOf(goal_schema::condition(), limits::conditions);
}

nlohmann::ordered_json ListCondition::draft(ConditionDraft const& with) const {
    return nlohmann::ordered_json::array({movedDraft(with)});
}

bool ListCondition::isCompound(Condition const& condition) const {
    return condition.text.empty() && condition.children.size() > 1;
}

std::string ListCondition::joined(Condition const& condition, GoalWords const& words, Mood mood,
                                  Noun const* it, bool conjunction) {
    std::vector<std::string> phrases;
    bool nested = false;
    for (Condition const& child : condition.children) {
        phrases.push_back(words.phrase(child, mood, it));
        nested = nested || child.kind->isCompound(child);
    }
    std::string text;
    if (nested && phrases.size() > 1) { // with semicolons, as there may be commas in the phrases
        for (std::size_t i = 0; i < phrases.size(); ++i) {
            bool const last = i + 1 == phrases.size();
            text += i == 0 ? "" : last ? words.speech().phrase(conjunction ? ", and " : ", or ") : "; ";
            text += phrases[i];
        }
    } else {
        text = enumerated(phrases, words.speech().phrase(conjunction ? "and" : "or"));
    }
    return conjunction || phrases.size() == 1 ? text : words.speech().phrase("either {}", {{text}});
}

} // namespace trembler::conditions
