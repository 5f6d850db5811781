// The energy that one frame of lag between simulations adds: oscillators driven by a force from another
// simulation and by a spring of dynamics' own.
#pragma once

namespace trembler {

struct GameData;

namespace accuracy {

/// Result of one oscillator over several oscillations.
struct Swing {
    double growth = 0;       ///< relative growth of the energy per oscillation: 0.1 is 10 %; 0 if conserved
    double predicted = 0;    ///< the same by predictedGrowth()
    double microseconds = 0; ///< per frame, of all components
};

/// The stiffnesses that drive an oscillator, as squares of angular frequencies (1/s²): stiffness over mass.
struct Stiffness {
    double lagged = 0; ///< of the lagged force from another simulation
    double own = 0;    ///< of the spring that dynamics integrates itself
};

/// The growth of the energy in an oscillation of period P = 2π/ω, ω² = lagged + own, to first order.
///
/// A force F(x) that is computed every `period` frames, of 1/60 s, and held constant for that time t equals
/// on average the force t/2 ago (sample and hold: Åström and Wittenmark, Computer-Controlled Systems, 1997,
/// Section 3). A force delayed by τ is F(x) - τ F'(x) v: with F' = -k it does the work τ k v² per second, a
/// negative friction, so amplitudes grow at the rate ½ τ k/m and energies at τ k/m. Substeps of semi-implicit
/// Euler, N per frame, reduce the delay by half a substep, because positions are integrated with the new
/// velocity: τ = t/2 (1 - 1/(N period)). A spring of Box2D is integrated by implicit Euler and loses energy
/// at the rate k/m times a substep.
///
/// `substeps` and `period` are at least 1. `lookAhead`: the lag is compensated (see LiquidDrag and
/// MagneticPoints). In a frame of several `parts` the force is held for one part, which has its share of the
/// substeps; then `period` is 1.
[[nodiscard]] double predictedGrowth(Stiffness const& stiffness, int substeps, int period, bool lookAhead,
                                     int parts = 1);

/// A magnet that a fixed magnet repels, balanced by a spring. Needs magnetism.
[[nodiscard]] Swing magnetOnSpring(GameData const& gameData, int substeps, bool lookAhead, int parts = 1);
/// A wide floating box on a spring, in a liquid without drag. Needs buoyancy and gravity.
[[nodiscard]] Swing floatOnSpring(GameData const& gameData, int substeps, int period, bool lookAhead);

} // namespace accuracy
} // namespace trembler
