// The resistance to motion in a liquid: drag, and the change of a body's buoyancy until it is computed again.
#pragma once

#include "physics/buoyancy/properties/air.hpp"
#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/buoyancy/properties/liquid_resistance.hpp"
#include "physics/buoyancy/properties/results.hpp"
#include "physics/buoyancy/properties/settings.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/force_lag.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "runtime/component/dps.hpp"
#include "runtime/placement.hpp"

namespace trembler {

/// Drag acts at the centroid of the immersed part, against its velocity v in the liquid:
/// F = -(c1 m + c2 ½ ρ w d |v|) v, with m the mass of the displaced liquid, w the width of the immersed part
/// across v, d the world's depth, c1 and c2 the linear and quadratic drag of the liquid or of the air.
/// Rotation is resisted likewise: T = -(c1 ρ d J + c2 ½ ρ d |ω| L⁴/32) ω, with J the polar moment of the
/// immersed part about that centroid and L its length, as for a plate that turns about its middle. Widths are
/// those of the rectangle with the same second moments.
///
/// Looking ahead: F_B is held for a time t (a frame, or the resolver's period) while the body moves. On
/// average it is the force of t/2 ago, and such a lag adds energy to oscillations. So the body is made to
/// resist motion up and down at its waterline with ρ g d t/2 per length, the average change of the force; and
/// rotation, with t/2 times F_B times the height of the centre of buoyancy above that of mass. The part of
/// this lag that the engine itself compensates is left out: see ForceLag.
///
/// How fast F_B varies: ω² = k/m + k'/I, k = ρ g d per length of the waterline, as a float of mass m bobs,
/// and k' its righting moment per angle, as it rolls.
class LiquidDrag final
    : public Dps<LiquidDrag,
                 Reads<Immersions, LinearGravityVector, Liquid, Air, Shape, Position, Rotation, Velocity,
                       AngularVelocity, Mass, ForceLag, BuoyancySettings>,
                 Derives<LiquidResistance>> {
public:
    static constexpr ComponentText text{
        .name = "Liquid Drag",
        .effect = "buoyancy",
        .level = "",
        .work = "For each object in a liquid, or in air, calculates linear and quadratic drag from its "
                "velocity, and "
                "the damping that makes up for F_B being held until it is computed again.",
        .rank = 1};
    using Activation = NeedsAny<Liquid, Air, InAir>;
    static constexpr int longestPeriod = 12;
    void update(Access& access);
};

/// The width (m), across the unit vector `direction`, of the rectangle that has these second moments, and its
/// greatest length.
[[nodiscard]] double widthAcross(AreaMoments const& wet, Vec2 direction);
[[nodiscard]] double lengthOf(AreaMoments const& wet);

} // namespace trembler
