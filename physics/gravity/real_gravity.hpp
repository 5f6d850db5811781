// Gravity between every two masses, detail level "real".
#pragma once

#include "physics/dynamics/properties/body.hpp"
#include "physics/gravity/masses.hpp"
#include "physics/gravity/properties.hpp"
#include "physics/inverse_square/points.hpp"
#include "runtime/component/dps.hpp"
#include "runtime/placement.hpp"

namespace trembler {

/// Newton's law for every pair, softened after Plummer (1911) so that it stays finite at zero distance:
/// F = G m1 m2 r / (r² + s²)^(3/2), with the constant G and the softening length s from GravityLaw.
class RealGravity final : public Dps<RealGravity, Reads<GravityLaw, Position, Mass>, Derives<GravityForce>> {
public:
    static constexpr ComponentText text{.name = "Real Gravity",
                                        .effect = "gravity",
                                        .level = "real",
                                        .work = "Exports the sum of the attractions of all other masses.",
                                        .rank = 0}; // a world that states a law of gravity needs this level
    using Activation = NeedsAll<GravityLaw, Mass, Position>;
    static constexpr int longestPeriod =
        4; // held for longer, the force is no longer an approximation of the same physics
    static constexpr Coverage memory = leftOut("refilled in each update");
    void update(Access& access);

private:
    inverse_square::Points sources_;
    inverse_square::Points receivers_;
    MassSums sums_;
};

} // namespace trembler
