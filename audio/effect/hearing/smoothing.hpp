// How a sound level meter averages.
#pragma once

#include "audio/effect/properties/decibel.hpp"

#include <cmath>

namespace trembler {

inline constexpr double fastTime = 0.125; ///< s, "fast" of IEC 61672-1

/// Pa², 10 dB below the threshold of hearing: below it a sound is over.
inline constexpr double inaudible = 0.1 * referencePressure * referencePressure;

/// Moves an exponential average on by `duration` (s), in which the quantity had the mean `mean`.
inline void smooth(double& average, double mean, double duration) {
    average += (mean - average) * -std::expm1(-duration / fastTime);
}

} // namespace trembler
