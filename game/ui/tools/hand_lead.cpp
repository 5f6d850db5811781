#include "game/ui/tools/hand_lead.hpp"

#include "runtime/component/component.hpp"

#include <algorithm>

namespace trembler::ui {

void HandLead::begin(Vec2 pointer) {
    last_.fill(pointer);
}

Vec2 HandLead::ahead(Vec2 pointer) {
    std::copy_backward(last_.begin(), last_.end() - 1, last_.end());
    last_.front() = pointer;
    Vec2 const now = last_[0] - last_[half];
    double const size = length(now);
    if (size <= 0) {
        return pointer;
    }
    double const kept = std::min(1.0, length(last_[half] - last_[2 * half]) / size);
    double const perSecond = 1 / (static_cast<double>(half) * frameDuration);
    double const share = std::min(kept * springDelay * perSecond, most / size);
    return pointer + share * now;
}

} // namespace trembler::ui
