// Why motion in a liquid dies away: drag, and what a body's buoyancy will have changed by next time.
#pragma once

#include "physics/buoyancy/liquid.hpp"
#include "physics/buoyancy/results.hpp"
#include "physics/buoyancy/settings.hpp"
#include "physics/dynamics/body.hpp"
#include "physics/dynamics/force_lag.hpp"
#include "physics/dynamics/shape.hpp"
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
        double rate = 0;    ///< 1/s, at which F_B varies as the object moves; see TellRate
        EventId event;      ///< "enters the liquid"; none while nobody traces
        template <class Self, class Visitor>
        static void describe(Self& self, Visitor&& visit) {
            visit(FieldInfo{.key = "object", .unit = "", .meaning = "whose motion it resists"}, self.object);
            visit(FieldInfo{.key = "point", .unit = "m", .meaning = "where it acts"}, self.point);
            visit(FieldInfo{.key = "xx",
                            .unit = "kg/s",
                            .meaning = "force against the velocity of the point, along x"},
                  self.xx);
            visit(FieldInfo{.key = "xy", .unit = "kg/s", .meaning = "across"}, self.xy);
            visit(FieldInfo{.key = "yy", .unit = "kg/s", .meaning = "along y"}, self.yy);
            visit(FieldInfo{.key = "angular",
                            .unit = "kg m²/s",
                            .meaning = "torque against the angular velocity"},
                  self.angular);
            visit(FieldInfo{.key = "push", .unit = "N", .meaning = "what a current adds"}, self.push);
        }
    };
    std::vector<Entry> entries;
    bool foreseen = false; ///< whether the entries resist what F_B will have changed by before it is new

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "entries", .unit = "", .meaning = "ascending by object"}, self.entries);
    }
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
/// mass. What the engine itself makes up for is left out: see ForceLag.
///
/// How fast F_B varies: ω² = k/m + k'/I, k = ρ g d per length of the waterline, as a float of mass m bobs,
/// and k' its righting moment per angle, as it rolls.
class LiquidDrag final : public Dps<LiquidDrag,
                                    Reads<Immersions, LinearGravityVector, Liquid, Shape, Position, Rotation,
                                          Velocity, AngularVelocity, Mass, ForceLag, BuoyancySettings>,
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
    static constexpr int longestPeriod = 12;
    void update(Access& access);
};

/// The width (m), across the unit vector `direction`, of the rectangle that has these second moments, and its
/// greatest length.
[[nodiscard]] double widthAcross(AreaMoments const& wet, Vec2 direction);
[[nodiscard]] double lengthOf(AreaMoments const& wet);

} // namespace trembler
