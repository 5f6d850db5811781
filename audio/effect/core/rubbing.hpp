// Formulas for the noise of surfaces that slide or roll on each other.
#pragma once

namespace trembler {

inline constexpr double slidingShare = 0.1;     ///< of the friction that is noise, an estimate
inline constexpr double rollingShare = 0.03;    ///< of the load that is noise in rolling, an estimate
inline constexpr double slowestRubbing = 0.02;  ///< m/s, least speed of audible sliding and rolling
inline constexpr double faintestRubbing = 1e-4; ///< N, least noise that is reported

/// The speed (m/s) with which the bumps of one surface pass those of the other: that of sliding (`slip`) or,
/// with almost no sliding, that of rolling (radius times angular velocity). 0 if neither is audible. Both in
/// m/s, 0 or more.
[[nodiscard]] double rubbingSpeed(double slip, double rolling);

/// The part of the force between the surfaces that is noise, in N: a share of Coulomb's friction μ N if they
/// slide, else of the load N. `load` in N; `friction` is the coefficient of the pair, for which Dynamics
/// takes the geometric mean of both.
[[nodiscard]] double rubbingForce(double load, double slip, double friction);

} // namespace trembler
