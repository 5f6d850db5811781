#include "game/ui/play/run/celebration.hpp"

namespace trembler::ui {

bool Celebration::noteStep(Session const& session) {
    if (solvedAt_ || !session.solved()) {
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
