// The delay of held forces.
#pragma once

#include "runtime/property/coverage.hpp"
#include "runtime/property/description.hpp"

#include <algorithm>

namespace trembler {

/// A force that is held for a time t acts, on average, t/2 after the moment for which it was computed. An
/// engine that integrates it in steps of h by the semi-implicit Euler method compensates h/2 of this, as that
/// method moves bodies with their velocity at the end of the step. The rest, (t - h)/2, is the lag: it adds
/// energy to every oscillation (docs/measurements/stability.md), and interactions that add forces can
/// compensate it. Provided by Dynamics after each of its steps; zero without Dynamics.
struct ForceLag {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{
        "Force lag", "force_lag", "The delay of forces behind the motion of the objects on which they act."};
    static constexpr Coverage coverage = hashed;
    static constexpr std::string_view standing = "the delay of forces";
    double turn = 0; ///< s, of one turn of Dynamics: a frame or a part of one
    double step = 0; ///< s, of the engine, `turn` or a part of it

    /// Lag in s of a force that is computed again for each turn of Dynamics.
    [[nodiscard]] double ofTurn() const { return of(turn); }
    /// Lag in s of a force that is held for `time` (s).
    [[nodiscard]] double of(double time) const { return std::max(0.0, time - step) / 2; }

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "turn", .unit = "s", .meaning = "time that each turn of Dynamics computes"},
              self.turn);
        visit(FieldInfo{.key = "step", .unit = "s", .meaning = "step of the engine"}, self.step);
    }
    friend bool operator==(ForceLag const&, ForceLag const&) = default;
};

} // namespace trembler
