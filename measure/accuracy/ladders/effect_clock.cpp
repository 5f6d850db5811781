#include "measure/accuracy/ladders/effect_clock.hpp"

#include "runtime/world/world.hpp"

#include <algorithm>
#include <numeric>

namespace trembler::accuracy {

double medianOf(std::vector<double> values) {
    if (values.empty()) {
        return 0;
    }
    auto const middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

void EffectClock::frame(World const& world) {
    bool const first = total_ < 0;
    if (!first && ++frames_ < window) {
        return;
    }
    double total = 0;
    for (ComponentStatus const& status : world.status()) {
        if (effect_.empty() || status.info->text.effect == effect_) {
            total += status.totalMicroseconds;
        }
    }
    if (!first) { // the first frame allocates memory and fills caches and is not counted
        means_.push_back((total - total_) / window);
    }
    total_ = total;
    frames_ = 0;
}

double EffectClock::median() const {
    return medianOf(means_);
}

double EffectClock::mean() const {
    double const windows = static_cast<double>(means_.size());
    return means_.empty() ? 0 : std::accumulate(means_.begin(), means_.end(), 0.0) / windows;
}

} // namespace trembler::accuracy
