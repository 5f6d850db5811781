// How bars, plates and balls vibrate: frequencies and shapes of their modes, from the theory of elasticity.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace trembler {

/// The n-th root (n >= 1) of cos β cosh β = 1: β = 4.7300, 7.8532, 10.9956 ... A free bar of length L, radius
/// of gyration κ and rod speed c vibrates at β² κ c / (2π L²) (Euler and Bernoulli; Fletcher and Rossing
/// 1998, Section 2.15).
[[nodiscard]] double barRoot(int n);
/// The deflection of that mode at `x` from 0 to 1 along the bar, scaled to a mean square of 1 (2 at the
/// ends). Finite and exact to 1e-9 for every n up to 1000.
[[nodiscard]] double barShape(int n, double x);

/// A free rectangular plate of sides a and b, with m and n nodal lines across them: its frequency times 2/π
/// sqrt(12 ρ (1-ν²) / E) / t, in 1/m², by Warburton's formula (The vibration of rectangular plates, Proc.
/// Inst. Mech. Eng. 168, 1954). Within about 15 % of Leissa's tables. m + n >= 2.
[[nodiscard]] double plateFactor(int m, int n, double a, double b, double poissonRatio);
/// The deflection along one side of a plate with n nodal lines across it, mean square 1.
[[nodiscard]] double plateShape(int n, double x);

/// A mode of a solid elastic ball that an impact on its surface excites.
struct BallMode {
    double root; ///< 2π f r / shear speed
    int degree;  ///< of its spherical harmonics
};
/// The spheroidal modes of a free ball with a Poisson ratio of 0.3, ascending: the roots of Lamb's equation
/// (On the vibrations of an elastic sphere, Proc. London Math. Soc. 13, 1882).
[[nodiscard]] std::span<BallMode const> ballModes();

/// A partial of a bell.
struct BellPartial {
    double ratio;  ///< to the prime
    double weight; ///< of its deflection at the rim
};
/// Hum, prime, tierce, quint, nominal and so on of a tuned bell with a minor third (Fletcher and Rossing
/// 1998, Section 21.5).
[[nodiscard]] std::span<BellPartial const> bellPartials();

} // namespace trembler
