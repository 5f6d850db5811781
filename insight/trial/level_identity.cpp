#include "insight/trial/level_identity.hpp"

#include "insight/trial/text_hash.hpp"
#include "runtime/level/write/write_level.hpp"

#include <nlohmann/json.hpp>

namespace trembler::insight {
namespace {

/// Removes the texts of all conditions, wherever they lie.
void removeTexts(nlohmann::json& goals) {
    if (goals.is_object()) {
        goals.erase("text");
    }
    if (goals.is_structured()) {
        for (nlohmann::json& inner : goals) {
            removeTexts(inner);
        }
    }
}

} // namespace

std::string identityOf(LevelFile const& level) {
    LevelFile bare = level;
    bare.title.clear();
    bare.text.clear();
    bare.hints.clear();
    bare.teaching.clear();
    bare.texts.clear();
    bare.solutions.clear();
    bare.editor = nullptr;
    removeTexts(bare.goals);
    removeTexts(bare.task);
    std::string const text = levelText(bare);
    return hashOf(text);
}

} // namespace trembler::insight
