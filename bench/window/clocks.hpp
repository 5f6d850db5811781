// Processor time, which other programs on the machine influence little, and quantiles of times.
#pragma once

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <vector>

namespace bench {

inline double secondsOf(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Processor time of a call on this thread alone, ms.
template <class F>
double threadMilliseconds(F&& f) {
    double const begin = secondsOf(CLOCK_THREAD_CPUTIME_ID);
    f();
    return 1000 * (secondsOf(CLOCK_THREAD_CPUTIME_ID) - begin);
}

/// The median of the frames, and the least time of the slowest 1 % of them, ms. Each frame's own time is its
/// least in several runs: runs repeat to the bit, and other work on the machine can only add to it.
class FrameTimes {
public:
    void add(std::size_t frame, double milliseconds) {
        if (frame >= least_.size()) {
            least_.resize(frame + 1, 1e300);
        }
        least_[frame] = std::min(least_[frame], milliseconds);
    }
    [[nodiscard]] double quantile(double share) const {
        if (least_.empty()) {
            return 0;
        }
        std::vector<double> sorted = least_;
        auto const at =
            std::min(static_cast<std::size_t>(share * static_cast<double>(sorted.size())), sorted.size() - 1);
        std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(at), sorted.end());
        return sorted[at];
    }
    [[nodiscard]] double median() const { return quantile(0.5); }
    [[nodiscard]] double worst() const { return quantile(0.99); }

private:
    std::vector<double> least_;
};

} // namespace bench
