#include "game/ui/cards/level_text.hpp"

#include "game/ui/shared/texts.hpp"
#include "puzzle/campaign/as_played.hpp"
#include "puzzle/goals/words/goal_text.hpp"

namespace trembler::ui {

void LevelText::newWorld() {
    language_ = languageInUse();
    LevelFile const level = asPlayed(session_.level(), language_);
    title_ = level.title;
    text_ = level.text;
    hints_ = level.hints;
    goals_ = goalSentences(level, session_.world(), speechInUse());
}

void LevelText::follow() {
    if (language_ != languageInUse()) {
        newWorld();
    }
}

} // namespace trembler::ui
