// What one frame of lag between simulations does to energy: oscillators that swing by a force from another
// simulation and by a spring of dynamics' own.
#pragma once

namespace trembler {

struct GameData;

namespace accuracy {

/// One oscillator, some oscillations long.
struct Swing {
    double growth = 0;       ///< of the energy in an oscillation: 0.1 is a tenth more; conserved would be 0
    double predicted = 0;    ///< the same by predictedGrowth()
    double microseconds = 0; ///< per frame, of all components
};

/// What drives an oscillator, as squares of angular frequencies (1/s²): stiffness over mass.
struct Stiffness {
    double lagged = 0; ///< of the force from another simulation
    double own = 0;    ///< of the spring that dynamics integrates itself
};

/// The growth of the energy in an oscillation of the length P = 2π/ω, ω² = lagged + own, to first order.
///
/// A force F(x) that is computed every `period` frames, of 1/60 s, and stands for that time t is on average
/// the force of t/2 ago (sample and hold: Åström and Wittenmark, Computer-Controlled Systems, 1997, Section
/// 3). A force that is late by τ is F(x) - τ F'(x) v: with F' = -k it does the work τ k v² per second, a
/// negative friction, so amplitudes grow at the rate ½ τ k/m and energies at τ k/m. Substeps of semi-implicit
/// Euler, N per frame, take back half a substep, as the velocity is new when places are moved by it: τ =
/// t/2 (1 - 1/(N period)). A spring of Box2D's is integrated by implicit Euler and loses energy at the rate
/// k/m times a substep.
///
/// `substeps` and `period` at least 1. `lookAhead`: the lagged force is made up for (see LiquidDrag and
/// MagneticPoints). In a frame of several `parts` the force stands for a part, which has its share of the
/// substeps; then `period` is 1.
[[nodiscard]] double predictedGrowth(Stiffness const& stiffness, int substeps, int period, bool lookAhead,
                                     int parts = 1);

/// A magnet that a fixed one pushes away holds itself against a spring. Needs magnetism.
[[nodiscard]] Swing magnetOnSpring(GameData const& gameData, int substeps, bool lookAhead, int parts = 1);
/// A wide box that floats, on a spring, in a liquid without drag. Needs buoyancy and gravity.
[[nodiscard]] Swing floatOnSpring(GameData const& gameData, int substeps, int period, bool lookAhead);

} // namespace accuracy
} // namespace trembler
