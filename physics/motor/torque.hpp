// Formulas for the torques of motors and generators.
#pragma once

#include "physics/motor/properties.hpp"

namespace trembler {

/// Moment of inertia (kg m²) with which two free bodies turn against one another, from those of both: their
/// relative motion is that of one body with the reduced inertia 1/(1/a + 1/b), as of reduced masses (Landau
/// and Lifshitz, Mechanics, § 13). Either may be infinite; the result is 0 if either is 0.
[[nodiscard]] double reducedInertia(double a, double b);

/// Torque (N m) of a motor that turns at `speed` (rad/s, relative to its mount): a straight line from its
/// torque at rest to zero at its idling speed and to negative values beyond, as for a direct-current motor
/// with permanent magnets. `inertia` (kg m²) is that of its rotor. The line is never steeper than the one
/// that brings a free rotor to its idling speed within `step` (s): otherwise a torque that is held for a
/// whole step would make a light rotor oscillate.
[[nodiscard]] double motorTorque(ElectricMotor const& motor, double speed, double inertia, double step);

/// 1/s: how fast that torque brings a free rotor to its idling speed; see StateRate. 0 where it is constant.
[[nodiscard]] double motorRate(ElectricMotor const& motor, double inertia, double step);

/// Torque (N m) of a generator: constant and against its rotation, but never more than the torque that stops
/// it within `step` (s).
[[nodiscard]] double brakingTorque(Generator const& generator, double speed, double inertia, double step);

} // namespace trembler
