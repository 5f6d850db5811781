// Limits for sleep, the same for each engine whose sleep is ours.
#pragma once

#include "runtime/math/vec2.hpp"

namespace trembler {

/// A body slower than this for that long is at rest, as in Box2D at its usual scale.
inline constexpr double slowSpeed = 0.0025;        // m/s
inline constexpr double slowSpin = 2.0 / 180 * pi; // rad/s
inline constexpr double timeToSleep = 0.5 - 1e-9;  // s

/// A body that drifts freely, however slowly, is not at rest. Above these limits a body without contacts and
/// joints must not fall asleep.
inline constexpr double driftAcceleration = 1e-3; // m/s²
inline constexpr double driftSpeed = 1e-4;        // m/s
inline constexpr double driftSpin = 1e-3;         // rad/s

} // namespace trembler
