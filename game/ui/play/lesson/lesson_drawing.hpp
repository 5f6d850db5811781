// Shows the present step of a lesson: a ghost of the part, a hand that does it, and few words.
#pragma once

#include "game/ui/play/play_parts.hpp"

namespace trembler::ui {

/// The part where it is to go; between Canvas::begin and end.
void drawLessonGhost(PlayParts& parts);
/// The hand, the rings around the button to press, and the words; between Gui::beginFrame and endFrame, after
/// all cards.
void drawLesson(PlayParts& parts);

} // namespace trembler::ui
