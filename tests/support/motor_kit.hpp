// Experiment III's motor at a given angle, and measurements of its rotation.
#pragma once

#include "runtime/level/model/level.hpp"
#include "runtime/world/world.hpp"

#include <vector>

namespace trembler {

/// The level with the motor's axis and spokes rotated by `angle` (rad) relative to the file.
[[nodiscard]] LevelFile turnedMotor(LevelFile level, double angle);

/// Tracks the rotation of a world's main axle; call once per frame.
class Tachometer {
public:
    explicit Tachometer(World const& world);
    void look(World const& world);

    /// Turns since the start, anticlockwise.
    [[nodiscard]] double turns() const { return turns_; }
    /// Times (s) at which whole turns were completed, interpolated between frames.
    [[nodiscard]] std::vector<double> const& marks() const { return marks_; }
    /// Durations (s) of the complete turns that began at `from` (s) or later.
    [[nodiscard]] std::vector<double> durations(double from) const;
    /// Angular velocities (rad/s) in every frame from `from` (s) on.
    [[nodiscard]] std::vector<double> speeds(double from) const;

private:
    double start_ = 0; // rad
    double turns_ = 0;
    std::vector<double> marks_;
    std::vector<double> speeds_; // by frame, from 1
};

} // namespace trembler
