#include "puzzle/goals/read_goals.hpp"

#include "puzzle/goals/reading/goal_reader.hpp"

namespace trembler {

std::optional<Condition> readGoals(LevelFile const& level, Problems& problems) {
    if (level.goals.is_null()) {
        return std::nullopt;
    }
    if (level.document) {
        return GoalReader(level).condition(JsonNode(*level.document, level.goals, "/goals", problems));
    }
    // The level was not read from a file: its goals become a document of their own, so that messages can show
    // where they are wrong.
    auto const document = JsonDocument::parse(
        nlohmann::json{{"goals", level.goals}}.dump(1, ' ', false, nlohmann::json::error_handler_t::replace),
        "(level)");
    return GoalReader(level).condition(JsonNode(*document, level.goals, "/goals", problems));
}

std::optional<Condition> readGoals(LevelFile const& level) {
    Problems problems;
    auto condition = readGoals(level, problems);
    problems.throwIfAny();
    return condition;
}

} // namespace trembler
