// Limits for sleep: a body that drifts freely, however slowly, is not at rest. Above these limits a body
// without contacts and joints must not fall asleep.
#pragma once

namespace trembler {

inline constexpr double driftAcceleration = 1e-3; // m/s²
inline constexpr double driftSpeed = 1e-4;        // m/s
inline constexpr double driftSpin = 1e-3;         // rad/s

} // namespace trembler
