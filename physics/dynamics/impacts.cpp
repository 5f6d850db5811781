#include "physics/dynamics/impacts.hpp"

#include <algorithm>

namespace trembler {

double ImpactBook::press(Key contact, double impulse) {
    auto const [at, isNew] = pressed_.emplace(contact, impulse);
    if (isNew) {
        return 0;
    }
    // An engine may spare a contact that bears a load for one substep, for example while it looks for the
    // time of another impact. When the load is back, that is no blow.
    constexpr double memory = 0.8;
    double const rise = impulse - at->second;
    at->second = std::max(impulse, memory * at->second);
    return std::max(rise, 0.0);
}

} // namespace trembler
