// The interaction functions of the Dynamics resolver, for any engine.
#pragma once

#include "runtime/component/call.hpp"
#include "runtime/math/vec2.hpp"
#include "runtime/property/description.hpp"

#include <array>

namespace trembler {

/// Forces below this, in N, are left out of traces.
inline constexpr double negligibleForce = 1e-3;

struct AddForce {
    static constexpr CallText text{"addForce", "(object, force)",
                                   "Adds the force (N) at the centre of mass."};
    static constexpr Algebra algebra = Algebra::sumOfRates;
    static constexpr double negligible = negligibleForce;
    ObjectId object;
    Vec2 force; ///< N
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "object", .unit = "", .meaning = "the object", .required = true}, self.object);
        visit(FieldInfo{.key = "force",
                        .unit = "N",
                        .meaning = "force at the centre of mass",
                        .minimum = -1e12,
                        .maximum = 1e12,
                        .required = true},
              self.force);
    }
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {object}; }
    [[nodiscard]] double magnitude() const { return length(force); }
};

struct AddForceToPoint {
    static constexpr CallText text{"addForceToPoint", "(object, point, force)",
                                   "Adds the force (N) at a point of the world (m)."};
    static constexpr Algebra algebra = Algebra::sumOfRates;
    static constexpr double negligible = negligibleForce;
    ObjectId object;
    Vec2 point; ///< m, in the world
    Vec2 force; ///< N
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "object", .unit = "", .meaning = "the object", .required = true}, self.object);
        visit(FieldInfo{.key = "point",
                        .unit = "m",
                        .meaning = "where it acts, in the world",
                        .minimum = -1e6,
                        .maximum = 1e6,
                        .required = true},
              self.point);
        visit(FieldInfo{.key = "force",
                        .unit = "N",
                        .meaning = "force",
                        .minimum = -1e12,
                        .maximum = 1e12,
                        .required = true},
              self.force);
    }
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {object}; }
    [[nodiscard]] double magnitude() const { return length(force); }
};

struct AddTorque {
    static constexpr CallText text{"addTorque", "(object, torque)", "Adds the torque (N m), anticlockwise."};
    static constexpr Algebra algebra = Algebra::sumOfRates;
    static constexpr double negligible = negligibleForce;
    ObjectId object;
    double torque = 0; ///< N m
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "object", .unit = "", .meaning = "the object", .required = true}, self.object);
        visit(FieldInfo{.key = "torque",
                        .unit = "N m",
                        .meaning = "anticlockwise",
                        .minimum = -1e12,
                        .maximum = 1e12,
                        .required = true},
              self.torque);
    }
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {object}; }
    [[nodiscard]] double magnitude() const { return std::abs(torque); }
};

struct AddDrag {
    static constexpr CallText text{"addDrag", "(object, point, coefficients, angular)",
                                   "Resists the velocity of a point of the object and its rotation, in "
                                   "proportion to both (kg/s, kg m²/s)."};
    static constexpr Algebra algebra = Algebra::sumOfRates;
    static constexpr double negligible = negligibleForce;
    ObjectId object;
    Vec2 point;         ///< m, in the world
    double xx = 0;      ///< kg/s: the force is -(xx, xy; xy, yy) times the point's velocity
    double xy = 0;      ///< kg/s
    double yy = 0;      ///< kg/s
    double angular = 0; ///< kg m²/s: the torque is -angular times the angular velocity
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "object", .unit = "", .meaning = "the object", .required = true}, self.object);
        visit(FieldInfo{.key = "point",
                        .unit = "m",
                        .meaning = "where it acts, in the world",
                        .minimum = -1e6,
                        .maximum = 1e6,
                        .required = true},
              self.point);
        visit(FieldInfo{.key = "xx",
                        .unit = "kg/s",
                        .meaning = "the force is -(xx, xy; xy, yy) times the velocity of the point",
                        .minimum = -1e12,
                        .maximum = 1e12},
              self.xx);
        visit(FieldInfo{.key = "xy", .unit = "kg/s", .meaning = "see xx", .minimum = -1e12, .maximum = 1e12},
              self.xy);
        visit(FieldInfo{.key = "yy", .unit = "kg/s", .meaning = "see xx", .minimum = -1e12, .maximum = 1e12},
              self.yy);
        visit(FieldInfo{.key = "angular",
                        .unit = "kg m²/s",
                        .meaning = "the torque is -angular times the angular velocity",
                        .minimum = -1e12,
                        .maximum = 1e12},
              self.angular);
    }
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {object}; }
    [[nodiscard]] double magnitude() const { return xx + yy + angular; }
};

/// A force is held for a frame, or for its effect's period, while the objects on which it depends move. An
/// interaction that adds a force states how fast it varies: the angular frequency ω = √(k/m) with which the
/// object would swing if the force alone held it, k being the change of the force per distance (N/m), or the
/// rate at which the object would come to rest if the force alone slowed it down. A factor of two does not
/// matter. A force without such a call counts as constant. Dynamics summarises these calls in ForceRates.
struct StateRate {
    static constexpr CallText text{
        "tellRate", "(object, rate, foreseen, swings)",
        "States how fast (1/s) a force on the object varies as the object moves, whether the force allows "
        "for the time for which it is held, and whether the object can oscillate by it."};
    static constexpr Algebra algebra = Algebra::greatest;
    static constexpr double negligible = 0;
    ObjectId object;
    double rate = 0;       ///< 1/s, >= 0
    bool foreseen = false; ///< the force is computed for the object's later place, or acts against its motion
    bool swings = true;    ///< it depends on the object's place; shorter parts of a frame follow it better
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "object", .unit = "", .meaning = "the object", .required = true}, self.object);
        visit(FieldInfo{.key = "rate",
                        .unit = "1/s",
                        .meaning = "how fast the force varies",
                        .minimum = 0,
                        .maximum = 1e12,
                        .required = true},
              self.rate);
        visit(
            FieldInfo{
                .key = "foreseen",
                .unit = "",
                .meaning =
                    "whether the force is computed for the object's later place, or acts against its motion"},
            self.foreseen);
        visit(FieldInfo{.key = "swings", .unit = "", .meaning = "whether it depends on the object's place"},
              self.swings);
    }
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {object}; }
    [[nodiscard]] std::uint64_t key() const { return packed(object); }
    [[nodiscard]] double value() const { return rate; }
    [[nodiscard]] double magnitude() const { return 0; } ///< no effect, so no event
};

struct AddImpulse {
    static constexpr CallText text{"addImpulse", "(object, point, impulse)",
                                   "Adds the impulse (N s) at a point of the world (m), once."};
    static constexpr Algebra algebra = Algebra::sumOfAmounts;
    ObjectId object;
    Vec2 point;   ///< m, in the world
    Vec2 impulse; ///< N s
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "object", .unit = "", .meaning = "the object", .required = true}, self.object);
        visit(FieldInfo{.key = "point",
                        .unit = "m",
                        .meaning = "where it acts, in the world",
                        .minimum = -1e6,
                        .maximum = 1e6,
                        .required = true},
              self.point);
        visit(FieldInfo{.key = "impulse",
                        .unit = "N s",
                        .meaning = "impulse",
                        .minimum = -1e12,
                        .maximum = 1e12,
                        .required = true},
              self.impulse);
    }
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {object}; }
};

struct DynamicsRole {
    static constexpr std::string_view name = "Dynamics";
    using Calls = CallList<AddForce, AddForceToPoint, AddTorque, AddDrag, StateRate, AddImpulse>;
};

} // namespace trembler
