// Experiment III's motor, turned as a test wants it, and what is measured of it.
#pragma once

#include "runtime/level/model/level.hpp"
#include "runtime/world/world.hpp"

#include <vector>

namespace trembler {

/// The level with its axis and spokes turned by that angle (rad) from where the file has them.
[[nodiscard]] LevelFile turnedMotor(LevelFile level, double angle);

/// Follows the main axis of a world, one look per frame.
class Tachometer {
public:
    explicit Tachometer(World const& world);
    void look(World const& world);

    /// Anticlockwise, since the start.
    [[nodiscard]] double turns() const { return turns_; }
    /// Times (s) at which a whole number of turns was complete, interpolated between frames.
    [[nodiscard]] std::vector<double> const& marks() const { return marks_; }
    /// How long each complete turn took (s), of those that began at `from` (s) or later.
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
