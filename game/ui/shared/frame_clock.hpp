// From the display's uneven frames to the simulation's even ones.
#pragma once

#include "runtime/component/component.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::ui {

/// Counts how many frames of 1/60 s are due, and how far the next one has come. Never looks at a clock
/// itself.
class FrameClock {
public:
    /// More than this per picture is not caught up with: a slow machine shows slow motion instead of standing
    /// still.
    static constexpr int mostFrames = 8;

    /// Frames to do for `seconds` of the player's time (s, not finite or negative counts as none) at `speed`
    /// times the usual pace (>= 1).
    [[nodiscard]] int due(double seconds, int speed = 1) {
        double const passed = std::isfinite(seconds) ? std::max(seconds, 0.0) : 0.0;
        waiting_ += passed * speed;
        // A display of just 60 Hz must not stumble over the last bit of a sum of sixtieths.
        double const whole = std::floor(waiting_ / frameDuration + 1e-6);
        waiting_ = std::max(waiting_ - whole * frameDuration, 0.0);
        return static_cast<int>(std::min<double>(whole, mostFrames * speed));
    }
    /// How far the display is between the last two frames, 0 to 1.
    [[nodiscard]] double alpha() const { return std::clamp(waiting_ / frameDuration, 0.0, 1.0); }
    void reset() { waiting_ = 0; }

private:
    double waiting_ = 0; // s
};

} // namespace trembler::ui
