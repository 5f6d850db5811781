#include "game/ui/cards/celebration.hpp"

namespace trembler::ui {

bool byPlayer(Session const& session) {
    bool const touched = !session.placed().empty() || !session.wires().empty() || !session.inputs().empty();
    return touched && !session.level().demonstration;
}

bool Celebration::noteStep(Session const& session) {
    if (solvedAt_ || !session.solved() || !byPlayer(session)) {
        return false;
    }
    solvedAt_ = session.world().time();
    showing_ = true;
    age_ = 0;
    return true;
}

void Celebration::reset() {
    solvedAt_.reset();
    showing_ = false;
}

} // namespace trembler::ui
