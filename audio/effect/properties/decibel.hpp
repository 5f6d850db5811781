// Sound levels and the constants of air.
#pragma once

namespace trembler {

inline constexpr double speedOfSound = 343;        ///< m/s, in air of 20 °C
inline constexpr double airImpedance = 413;        ///< Pa s/m: density of air times speed of sound
inline constexpr double airDensity = 1.204;        ///< kg/m³
inline constexpr double referencePressure = 20e-6; ///< Pa, 0 dB
inline constexpr double lowestAudible = 20;        ///< Hz
inline constexpr double highestAudible = 20000;    ///< Hz
inline constexpr double silentLevel = -120;        ///< dB; counts as silence

/// The level, in dB, of a mean square pressure in Pa²; at least silentLevel.
[[nodiscard]] double levelOf(double meanSquare);
/// The factor on a power for a number of decibels. Computed by exp(), as compilers translate pow(10, x)
/// differently, and the last bit must not depend on that.
[[nodiscard]] double powerOf(double decibels);
/// The mean square pressure, in Pa², of a level in dB.
[[nodiscard]] double meanSquareOf(double level);
/// The ear's sensitivity to a tone: the factor on its mean square pressure by A-weighting, IEC 61672-1, Annex
/// E; 1 at 1 kHz.
[[nodiscard]] double aWeighting(double frequency);

} // namespace trembler
