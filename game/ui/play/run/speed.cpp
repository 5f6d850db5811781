#include "game/ui/play/run/speed.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::ui {
namespace {

/// A picture that takes longer than this, in s, computed too many frames.
constexpr double longPicture = 0.1;
/// Duration of a measurement, s, and how many must fail before the computer counts as too slow: a single one
/// fails whenever the window was dragged.
constexpr double measurement = 1;
constexpr int failures = 2;
constexpr double tolerated = 0.9;

} // namespace

int Speed::due(double seconds) {
    double const speed = now();
    int frames = clock_.due(seconds, speed);
    if (speed > 1) {
        if (seconds > longPicture && last_ > 1) {
            most_ = std::max(last_ / 2, 1);
        } else if (most_ > 0) {
            ++most_;
        }
        if (most_ > 0 && frames <= most_) {
            most_ = frames < most_ ? 0 : most_; // it keeps up again
        } else if (most_ > 0) {
            frames = most_;
        }
    } else {
        most_ = 0;
    }
    last_ = frames;
    measure(seconds, frames);
    return frames;
}

void Speed::measure(double seconds, int frames) {
    if (!std::isfinite(seconds) || seconds <= 0) {
        return;
    }
    span_ += seconds;
    asked_ += seconds * now();
    shown_ += frames * frameDuration;
    if (span_ < measurement) {
        return;
    }
    reached_ = shown_ / span_;
    behind_ = shown_ < tolerated * asked_ ? behind_ + 1 : 0;
    span_ = shown_ = asked_ = 0;
}

void Speed::reset() {
    clock_.reset();
    last_ = most_ = behind_ = 0;
    span_ = shown_ = asked_ = 0;
}

std::optional<double> Speed::onlyReached() const {
    return behind_ >= failures ? std::optional(reached_) : std::nullopt;
}

} // namespace trembler::ui
