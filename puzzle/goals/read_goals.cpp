#include "puzzle/goals/read_goals.hpp"

#include "puzzle/goals/reading/goal_reader.hpp"

namespace trembler {
namespace {

/// Of the condition that a level states under `key`.
std::optional<Condition> readCondition(LevelFile const& level, nlohmann::json const& stated,
                                       std::string const& key, Problems& problems) {
    if (stated.is_null()) {
        return std::nullopt;
    }
    std::string const path = "/" + key;
    if (level.document) {
        return GoalReader(level).condition(JsonNode(*level.document, stated, path, problems));
    }
    // The level was not read from a file: its goals become a document of their own, so that messages can show
    // where they are wrong.
    auto const document = JsonDocument::parse(
        nlohmann::json{{key, stated}}.dump(1, ' ', false, nlohmann::json::error_handler_t::replace),
        "(level)");
    return GoalReader(level).condition(JsonNode(*document, stated, path, problems));
}

} // namespace

std::optional<Condition> readGoals(LevelFile const& level, Problems& problems) {
    return readCondition(level, level.goals, "goals", problems);
}

std::optional<Condition> readGoals(LevelFile const& level) {
    Problems problems;
    auto condition = readGoals(level, problems);
    problems.throwIfAny();
    return condition;
}

std::optional<Condition> readTask(LevelFile const& level, Problems& problems) {
    return readCondition(level, level.task, "task", problems);
}

std::optional<Condition> readTask(LevelFile const& level) {
    Problems problems;
    auto condition = readTask(level, problems);
    problems.throwIfAny();
    return condition;
}

} // namespace trembler
