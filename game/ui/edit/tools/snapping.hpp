// The grid of places and angles to which moved objects snap.
#pragma once

#include "runtime/math/vec2.hpp"

#include <cmath>
#include <numbers>

namespace trembler::ui {

/// Plain data. The designer enters the steps as numbers.
struct Snapping {
    static constexpr double smallestGrid = 0.001; ///< m
    static constexpr double largestGrid = 10;
    static constexpr double smallestAngle = 0.1; ///< degrees
    static constexpr double largestAngle = 90;

    bool on = true;
    double grid = 0.05; ///< m
    double angleDegrees = 15;

    /// The nearest place of the grid; the place itself if snapping is off.
    [[nodiscard]] Vec2 place(Vec2 at) const {
        return on ? Vec2{rounded(at.x, grid), rounded(at.y, grid)} : at;
    }
    [[nodiscard]] double along(double metres) const { return on ? rounded(metres, grid) : metres; }
    /// The nearest multiple of the angle's step, rad.
    [[nodiscard]] double angle(double radians) const {
        return on ? rounded(radians * 180 / std::numbers::pi, angleDegrees) * std::numbers::pi / 180
                  : radians;
    }

private:
    /// Through the number of steps, and without the rounding errors of binary fractions: files are read by
    /// people.
    [[nodiscard]] static double rounded(double value, double step) {
        double const steps = std::round(value / step);
        double const product = steps * step;
        double const tidy = std::round(product * 1e6) / 1e6;
        return std::abs(tidy - product) < 1e-9 ? tidy : product;
    }
};

} // namespace trembler::ui
