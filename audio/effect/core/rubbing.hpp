// The noise of surfaces that slide or roll on each other, in numbers only.
#pragma once

namespace trembler {

inline constexpr double slidingShare = 0.1;  ///< of the friction that is noise, an estimate
inline constexpr double rollingShare = 0.03; ///< of the load that is noise where something rolls, an estimate
inline constexpr double slowestRubbing = 0.02;  ///< m/s, of sliding and rolling that is heard
inline constexpr double faintestRubbing = 1e-4; ///< N, of noise that is reported

/// The speed (m/s) with which the bumps of one surface pass those of the other: that of sliding (`slip`), or
/// where hardly anything slides, that of rolling (the radius times the turning). 0 where neither is heard.
/// Both in m/s, 0 or more.
[[nodiscard]] double rubbingSpeed(double slip, double rolling);

/// The part of the force between the surfaces that is noise, in N: a share of Coulomb's friction μ N where
/// they slide, else of the load N. `load` in N; `friction` is the coefficient of the pair, for which Dynamics
/// takes the geometric mean of both.
[[nodiscard]] double rubbingForce(double load, double slip, double friction);

} // namespace trembler
