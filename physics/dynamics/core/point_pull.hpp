// Formulas for a pull at a point of a rigid body.
#pragma once

#include "runtime/math/vec2.hpp"

namespace trembler {

/// Acceleration (m/s²) of a point on a critically damped spring of that angular frequency (1/s): ω² d - 2 ω
/// v, the equation of the damped oscillator with damping ratio 1 (Landau and Lifshitz, Mechanics, § 25).
/// `away` (m) leads from the point to the place that the spring pulls it to, `velocity` (m/s) is the point's.
[[nodiscard]] inline Vec2 criticallyDamped(double frequency, Vec2 away, Vec2 velocity) {
    return frequency * frequency * away - 2 * frequency * velocity;
}

/// The force (N) that, applied to a point of a free rigid body at rest, gives this point an acceleration
/// (m/s²). `arm` (m) leads to the point from the centre of mass, `mass` in kg, `inertiaPerMass` (m²) is the
/// square of the radius of gyration k about the centre of mass, above 0 unless the arm is 0 too.
///
/// The point's acceleration under a force f is (1 + A Aᵀ/k²) f/m, with A the arm turned by a quarter; solved
/// for f by the Sherman-Morrison formula. The inertia along the arm is the whole mass, across it less.
[[nodiscard]] inline Vec2 forceToAccelerate(Vec2 acceleration, Vec2 arm, double mass, double inertiaPerMass) {
    Vec2 const across = perpendicular(arm);
    double const share = dot(across, acceleration) / (inertiaPerMass + lengthSquared(arm));
    return mass * (acceleration - share * across);
}

} // namespace trembler
