#include "puzzle/campaign/as_played.hpp"

#include <utility>

namespace trembler {
namespace {

/// Sets the text of every condition with one of these ids, wherever it lies.
void translateGoals(nlohmann::json& goals, std::map<std::string, std::string> const& texts) {
    if (goals.is_object()) {
        if (auto const id = goals.find("id"); id != goals.end() && id->is_string()) {
            if (auto const text = texts.find(id->get<std::string>()); text != texts.end()) {
                goals["text"] = text->second;
            }
        }
    }
    if (goals.is_structured()) {
        for (auto& child : goals) {
            translateGoals(child, texts);
        }
    }
}

} // namespace

LevelFile asPlayed(LevelFile level, std::string const& language) {
    if (level.demonstration && !level.task.is_null()) {
        level.goals = std::exchange(level.task, nlohmann::json());
        level.demonstration = false;
    }
    auto const found = level.texts.find(language);
    if (found == level.texts.end()) {
        return level;
    }
    Translation const& texts = found->second;
    level.title = titleIn(level.texts, language, level.title);
    level.text = textIn(level.texts, language, level.text);
    if (!texts.hints.empty()) {
        level.hints = texts.hints;
    }
    translateGoals(level.goals, texts.goals);
    return level;
}

} // namespace trembler
