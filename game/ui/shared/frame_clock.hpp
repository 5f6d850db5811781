// Converts the display's uneven times between pictures to simulation frames of equal length.
#pragma once

#include "runtime/component/component.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::ui {

/// Counts how many frames of 1/60 s are due, and the fraction of the next one. Does not read a clock itself.
class FrameClock {
public:
    /// Maximum number of frames to catch up per picture at normal speed; more are dropped: a slow machine
    /// shows slow motion instead of standing still.
    static constexpr int mostFrames = 8;

    /// Simulation frames due after `seconds` of real time (s; negative or not finite counts as 0) at `speed`
    /// times real time (> 0).
    [[nodiscard]] int due(double seconds, double speed = 1) {
        double const passed = std::isfinite(seconds) ? std::max(seconds, 0.0) : 0.0;
        waiting_ += passed * speed;
        // Tolerance: on a display of exactly 60 Hz, rounding errors in the sum must not delay a frame.
        double const whole = std::floor(waiting_ / frameDuration + 1e-6);
        waiting_ = std::max(waiting_ - whole * frameDuration, 0.0);
        return static_cast<int>(std::min(whole, mostFrames * std::max(speed, 1.0)));
    }
    /// Interpolation factor between the last two frames for display, 0 to 1.
    [[nodiscard]] double alpha() const { return std::clamp(waiting_ / frameDuration, 0.0, 1.0); }
    void reset() { waiting_ = 0; }

private:
    double waiting_ = 0; // s
};

} // namespace trembler::ui
