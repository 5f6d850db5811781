// Why motion in a liquid dies away: drag, and what a body's buoyancy will have changed by next time.
#pragma once

#include "physics/buoyancy/liquid.hpp"
#include "physics/buoyancy/results.hpp"
#include "physics/buoyancy/settings.hpp"
#include "physics/dynamics/shape.hpp"
#include "physics/dynamics/solver_choice.hpp"
#include "runtime/component/dps.hpp"
#include "runtime/placement.hpp"

namespace trembler {

/// What resists the motion of each immersed object, as coefficients of velocities and not as forces: so
/// whoever moves the objects can integrate it without ever overshooting, however light they are. Ascending by
/// object.
struct LiquidResistance {
    static constexpr PropertyKind kind = PropertyKind::derived;
    static constexpr PropertyText text{"Liquid resistance", "liquid_resistance",
                                       "What resists the motion of each object in a liquid."};
    struct Entry {
        ObjectId object;
        Vec2 point;         ///< m, in the world, where it acts
        double xx = 0;      ///< kg/s: force against the point's velocity,
        double xy = 0;      ///< kg/s  a symmetric matrix
        double yy = 0;      ///< kg/s
        double angular = 0; ///< kg m²/s: torque against the angular velocity
        Vec2 push;          ///< N: what a current adds at the point
        EventId event;      ///< "enters the liquid"; none while nobody traces
    };
    std::vector<Entry> entries;

    template <class Self, class Visitor>
    static void describe(Self&, Visitor&&) {}
};

/// Drag acts at the centroid of what is immersed, against its velocity v in the liquid:
/// F = -(c1 m + c2 ½ ρ w d |v|) v, with m the mass of the displaced liquid, w the width of what is immersed
/// across v, d the world's depth, c1 and c2 the liquid's linear and quadratic drag; and against the turning
/// likewise: T = -(c1 ρ d J + c2 ½ ρ d |ω| L⁴/32) ω, with J the polar moment of what is immersed about that
/// centroid and L its length, as for a plate that turns about its middle. Widths are those of the rectangle
/// with the same second moments.
///
/// Looking ahead: F_B stands for a time t (a frame, or the resolver's period) while the body moves on. On
/// average it is the force of t/2 ago, and a force that lags behind feeds oscillations. So the body is made
/// to resist motion up and down at its waterline with ρ g d t/2 per length, which is what the force will have
/// lost on average; and turning, with t/2 times F_B times the height of the centre of buoyancy above that of
/// mass. What the engine's own N substeps make up for is left out: (1 - 1/N) t/2.
class LiquidDrag final : public Dps<LiquidDrag,
                                    Reads<Immersions, LinearGravityVector, Liquid, Shape, Position, Rotation,
                                          Velocity, AngularVelocity, SolverChoice, BuoyancySettings>,
                                    Derives<LiquidResistance>> {
public:
    static constexpr ComponentText text{
        .name = "Liquid Drag",
        .effect = "buoyancy",
        .level = "",
        .work =
            "For each object in a liquid, calculates linear and quadratic drag from its velocity, and what "
            "must resist its motion while F_B stands unchanged.",
        .cost = 1};
    using CalledFor = NeedsAll<Liquid, Shape, Velocity>;
    void update(Access& access);
};

/// The width (m), across the unit vector `direction`, of the rectangle that has these second moments, and its
/// greatest length.
[[nodiscard]] double widthAcross(AreaMoments const& wet, Vec2 direction);
[[nodiscard]] double lengthOf(AreaMoments const& wet);

} // namespace trembler
