#include "game/ui/edit/goals/goal_words.hpp"

#include "game/ui/shared/texts.hpp"

namespace trembler::ui {

std::string shownGoalWord(std::string const& word) {
    std::string const id = "condition." + word;
    std::string shown = text(id);
    return shown == id ? word : shown;
}

} // namespace trembler::ui
