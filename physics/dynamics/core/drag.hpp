// Forces against motion, as coefficients, so that an engine can integrate them without overshooting.
#pragma once

#include "runtime/math/vec2.hpp"

namespace trembler {

/// The symmetric, positive semidefinite matrix D of a resistance -D (vx, vy, ω) to the motion of a body,
/// about its centre of mass. Several resistances can be added.
struct Drag {
    double xx = 0; ///< kg/s
    double xy = 0;
    double yy = 0;
    double xt = 0; ///< kg m/s: between velocity and turning
    double yt = 0;
    double tt = 0; ///< kg m²/s

    [[nodiscard]] bool any() const { return xx > 0 || yy > 0 || tt > 0; }
    /// Adds a resistance that acts at `arm` (m) from the centre of mass: a force of -(axx, axy; axy, ayy)
    /// times the velocity of that point, and a torque of -angular times ω.
    void add(Vec2 arm, double axx, double axy, double ayy, double angular);
};

inline constexpr double maximumDrag = 1e15; ///< kg/s, kg m²/s: greater values have the same effect

/// Whether the coefficients are valid: they never accelerate a body, and do not exceed maximumDrag.
[[nodiscard]] bool isResistance(double xx, double xy, double yy, double angular);

/// A velocity or a momentum of a body: of its centre of mass and of its rotation.
struct Twist {
    Vec2 linear;
    double angular = 0;
};

/// The impulse (N s, N m s) that drag exerts within a time h (s) on a body that would otherwise leave it with
/// momentum `free`: by the implicit Euler method, (M + h D) v' = free, so that it slows the body down, but
/// never reverses its motion, whatever the coefficients.
[[nodiscard]] Twist dragImpulse(Drag const& drag, double mass, double inertia, Twist const& free, double h);

/// Drag on one body, substep by substep.
///
/// Drag must resist the acceleration by the loads within the step, or light bodies would get far too fast
/// before it acts. But a load that joints and contacts bear causes no acceleration: a raft that lies still
/// under its cargo must have no drag. The part that they bore in the last substep is a good estimate of the
/// part that they will bear in this one; it is subtracted from the load, at most down to zero.
class DraggedBody {
public:
    Drag drag;

    /// The impulse to apply before a substep of h (s), to a body of momentum `now` on which a load will exert
    /// the impulse `load`.
    [[nodiscard]] Twist before(double mass, double inertia, Twist const& now, Twist const& load, double h);
    /// Receives the momentum after the substep.
    void after(Twist const& now);

private:
    Twist expected_; // momentum without joints and contacts
    Twist taken_;    // impulse of joints and contacts
};

} // namespace trembler
