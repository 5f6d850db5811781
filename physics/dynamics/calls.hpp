// The interaction functions of the Dynamics resolver, whichever engine is behind it.
#pragma once

#include "runtime/component/call.hpp"
#include "runtime/math/vec2.hpp"

#include <array>

namespace trembler {

/// Forces below this, in N, are not worth a line in a trace.
inline constexpr double negligibleForce = 1e-3;

struct AddForce {
    static constexpr CallText text{"addForce", "(object, force)",
                                   "Adds the force (N) at the centre of mass."};
    static constexpr Algebra algebra = Algebra::sumOfRates;
    static constexpr double negligible = negligibleForce;
    ObjectId object;
    Vec2 force; ///< N
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
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {object}; }
    [[nodiscard]] double magnitude() const { return length(force); }
};

struct AddTorque {
    static constexpr CallText text{"addTorque", "(object, torque)", "Adds the torque (N m), anticlockwise."};
    static constexpr Algebra algebra = Algebra::sumOfRates;
    static constexpr double negligible = negligibleForce;
    ObjectId object;
    double torque = 0; ///< N m
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {object}; }
    [[nodiscard]] double magnitude() const { return std::abs(torque); }
};

struct AddDrag {
    static constexpr CallText text{"addDrag", "(object, point, coefficients, angular)",
                                   "Resists the motion of a point of the object and its turning, in "
                                   "proportion to both (kg/s, kg m²/s)."};
    static constexpr Algebra algebra = Algebra::sumOfRates;
    static constexpr double negligible = negligibleForce;
    ObjectId object;
    Vec2 point;         ///< m, in the world
    double xx = 0;      ///< kg/s: the force is -(xx, xy; xy, yy) times the point's velocity
    double xy = 0;      ///< kg/s
    double yy = 0;      ///< kg/s
    double angular = 0; ///< kg m²/s: the torque is -angular times the angular velocity
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {object}; }
    [[nodiscard]] double magnitude() const { return xx + yy + angular; }
};

struct AddImpulse {
    static constexpr CallText text{"addImpulse", "(object, point, impulse)",
                                   "Adds the impulse (N s) at a point of the world (m), once."};
    static constexpr Algebra algebra = Algebra::sumOfAmounts;
    ObjectId object;
    Vec2 point;   ///< m, in the world
    Vec2 impulse; ///< N s
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {object}; }
};

struct DynamicsRole {
    static constexpr std::string_view name = "Dynamics";
    using Calls = CallList<AddForce, AddForceToPoint, AddTorque, AddDrag, AddImpulse>;
};

} // namespace trembler
