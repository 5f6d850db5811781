#include "audio/effect/properties/decibel.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {

double levelOf(double meanSquare) {
    constexpr double reference = referencePressure * referencePressure;
    return meanSquare > 0 ? std::max(silentLevel, 10 * std::log10(meanSquare / reference)) : silentLevel;
}

double powerOf(double decibels) {
    constexpr double perDecibel = 0.23025850929940457; // ln 10 / 10
    return std::exp(perDecibel * decibels);
}

double meanSquareOf(double level) {
    return referencePressure * referencePressure * powerOf(level);
}

double aWeighting(double frequency) {
    double const f2 = frequency * frequency;
    double const amplitude = 12194.217 * 12194.217 * f2 * f2 /
                             ((f2 + 20.598997 * 20.598997) *
                              std::sqrt((f2 + 107.65265 * 107.65265) * (f2 + 737.86223 * 737.86223)) *
                              (f2 + 12194.217 * 12194.217));
    constexpr double atOneKilohertz = 0.794328; // -2.000 dB
    double const relative = amplitude / atOneKilohertz;
    return relative * relative;
}

} // namespace trembler
