// Islands of touching or joined bodies fall asleep, and wake, together.
#include "physics/dynamics/engines/native/native_engine.hpp"
#include "physics/dynamics/engines/sleep_limits.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::native {

bool NativeEngine::idles(SlotIndex slot) const {
    BodyEntry const& entry = bodies_[slot];
    double const speed = length(states_[slot].velocity);
    double const spin = std::abs(states_[slot].spin);
    return entry.restlessJoints == 0 && speed <= slowSpeed && spin <= slowSpin;
}

void NativeEngine::findRest(double duration) {
    for (Island const& island : islands_.groups()) {
        bool touching = !island.joints.empty();
        for (std::uint32_t const contact : island.contacts) {
            touching = touching || contacts_[contact].touches;
        }
        double least = timeToSleep;
        for (SlotIndex const slot : island.bodies) {
            BodyEntry& entry = bodies_[slot];
            bool idle = idles(slot);
            if (idle && !touching) { // a body that drifts freely, however slowly, is not at rest
                idle = length(entry.load.force) <= driftAcceleration * entry.mass &&
                       length(states_[slot].velocity) <= driftSpeed &&
                       std::abs(states_[slot].spin) <= driftSpin;
            }
            entry.idle = idle ? entry.idle + duration : 0;
            least = std::min(least, entry.idle);
        }
        if (least < timeToSleep || island.bodies.empty()) {
            continue;
        }
        std::uint32_t const nap = ++naps_;
        for (SlotIndex const slot : island.bodies) {
            awake_[slot] = 0;
            bodies_[slot].nap = nap;
            states_[slot].velocity = {};
            states_[slot].spin = 0;
        }
    }
}

} // namespace trembler::native
