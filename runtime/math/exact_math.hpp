// Mathematical functions that give the same bits on every machine and from every compiler: arithmetic of
// doubles in a stated order, without the C library, whose results differ from version to version.
#pragma once

namespace trembler {

/// Angles in rad, of at most largestAngle in size: beyond, the reduction to one turn would lose digits.
inline constexpr double largestAngle = 1e6;

/// Errors are below 2 units in the last place for angles up to 30 rad, and below 2e-16 for all.
[[nodiscard]] double exactSin(double angle);
[[nodiscard]] double exactCos(double angle);
struct CosineAndSine {
    double cosine = 1;
    double sine = 0;
};
/// Both of an angle of any size: beyond largestAngle, after whole turns of the double nearest to 2π are taken
/// away. Not numbers if the angle is not finite.
[[nodiscard]] CosineAndSine exactTurn(double angle);
/// The angle of (x, y) in [-π, π], to 3 units in the last place; 0 for (0, 0).
[[nodiscard]] double exactAtan2(double y, double x);
/// To 2 units in the last place; 0 below -700 and infinity above 709.
[[nodiscard]] double exactExp(double x);
/// Natural logarithm, to 2 units in the last place. Not a number below zero, minus infinity at zero.
[[nodiscard]] double exactLog(double x);

} // namespace trembler
