#include "puzzle/run/slow_frame.hpp"

#include "runtime/world/world.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>

namespace trembler {

double processorSeconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::string inWords(SlowFrame const& slow) {
    return fmt::format("frame {} took {:.1f} s of processor time, most of it in {}", slow.frame, slow.seconds,
                       slow.component.empty() ? "no component" : slow.component);
}

std::optional<SlowFrame> FrameTimer::end(World const& world) const {
    double const seconds = clock_() - begun_;
    if (seconds <= limit_) {
        return std::nullopt;
    }
    SlowFrame slow{world.frame(), seconds, {}};
    auto const status = world.status();
    auto const most = std::max_element(status.begin(), status.end(), [](auto const& a, auto const& b) {
        return a.lastMicroseconds < b.lastMicroseconds;
    });
    if (most != status.end()) {
        slow.component = most->info->text.name;
    }
    return slow;
}

} // namespace trembler
