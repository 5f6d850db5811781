// The averaging of sound level meters.
#pragma once

#include "audio/effect/properties/decibel.hpp"

#include <cmath>

namespace trembler {

inline constexpr double fastTime = 0.125; ///< s, "fast" of IEC 61672-1

/// Pa², 10 dB below the threshold of hearing: below it a sound has ended.
inline constexpr double inaudible = 0.1 * referencePressure * referencePressure;

/// Advances an exponential average by `duration` (s), in which the quantity had the mean `mean`.
inline void smooth(double& average, double mean, double duration) {
    average += (mean - average) * -std::expm1(-duration / fastTime);
}

} // namespace trembler
