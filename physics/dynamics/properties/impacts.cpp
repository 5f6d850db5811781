#include "physics/dynamics/properties/impacts.hpp"

#include <algorithm>
#include <tuple>

namespace trembler {

void Impacts::gather(Impacts& frame, Impacts const& part, PartSpan span) {
    for (Impact impact : part.impacts) {
        impact.since += span.begin;
        frame.impacts.push_back(impact);
    }
    std::stable_sort(frame.impacts.begin(), frame.impacts.end(), [](Impact const& x, Impact const& y) {
        return std::tie(x.a, x.b, x.since) < std::tie(y.a, y.b, y.since);
    });
}

double ImpactBook::press(Key contact, double impulse) {
    auto const [at, isNew] = pressed_.emplace(contact, impulse);
    if (isNew) {
        return 0;
    }
    // An engine may leave out a contact that bears a load for one substep, for example while it finds the
    // time of another impact. The returning load is no impact.
    constexpr double memory = 0.8;
    double const rise = impulse - at->second;
    at->second = std::max(impulse, memory * at->second);
    return std::max(rise, 0.0);
}

} // namespace trembler
