// Joints connect bodies. A joint is a separate object with this property.
#pragma once

#include "physics/dynamics/properties/joint_look.hpp"
#include "runtime/property/description.hpp"

#include <array>

namespace trembler {

enum class JointForm : int { hinge, weld, slider, distance, rope, pulley, gear, wheel, spring };
template <>
inline constexpr std::array<std::string_view, 9> choiceNames<JointForm>{
    "hinge", "weld", "slider", "distance", "rope", "pulley", "gear", "wheel", "spring"};

/// Connects object `a` to object `b`; without `b`, to the world. Which fields are used depends on the form.
/// Angles, shifts and motor speeds are those of `a` relative to `b`.
struct Joint {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Joint", "joint",
                                       "Connects two objects, or one object and the world."};

    JointForm form = JointForm::hinge;
    ObjectId a{};
    ObjectId b{};          ///< invalid: the world
    Vec2 at{};             ///< m, in the world at the start: the pin, or the end at `a`
    Vec2 atB{};            ///< m, in the world at the start: the end at `b` (distance, rope, spring, pulley)
    Vec2 axis{1, 0};       ///< direction in the world at the start (slider, wheel)
    bool limited = false;  ///< hinge, slider, wheel (along its axis): keep between lower and upper
    double lower = 0;      ///< rad or m
    double upper = 0;      ///< rad or m
    bool motor = false;    ///< hinge, slider, wheel
    double motorSpeed = 0; ///< rad/s (hinge, wheel) or m/s (slider)
    double motorStrength = 0; ///< N m or N at most
    double length = 0;        ///< m; 0: the distance at the start (distance, rope, spring)
    double stiffness = 0;     ///< N/m (spring, wheel)
    double dampingRate = 0;   ///< N s/m (spring, wheel)
    double ratio = 1;         ///< pulley: rope of a + ratio * rope of b, gear: a + ratio * b stays constant
    Vec2 groundA{};           ///< m, pulley: the wheel of the rope of `a`
    Vec2 groundB{};           ///< m, pulley: the wheel of the rope of `b`
    ObjectId jointA{};        ///< gear: the hinge or slider joint of `a`
    ObjectId jointB{};        ///< gear: the hinge or slider joint of `b`
    bool collide = false;     ///< whether the connected objects can collide
    double breakForce = 0;    ///< N at which it breaks; 0: never
    JointLook look{};

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        constexpr double far = 1e6;
        visit(FieldInfo{.key = "form", .unit = "", .meaning = "kind of joint", .required = true}, self.form);
        visit(FieldInfo{.key = "a", .unit = "", .meaning = "first object", .required = true}, self.a);
        visit(FieldInfo{.key = "b", .unit = "", .meaning = "second object; the world if left out"}, self.b);
        visit(FieldInfo{.key = "at",
                        .unit = "m",
                        .meaning = "pivot, or end at a, in the world at the start",
                        .minimum = -far,
                        .maximum = far,
                        .geometry = FieldGeometry::worldPoint},
              self.at);
        visit(
            FieldInfo{.key = "at_b",
                      .unit = "m",
                      .meaning = "end at b, in the world at the start: of a distance, rope, spring or pulley",
                      .minimum = -far,
                      .maximum = far,
                      .geometry = FieldGeometry::worldPoint},
            self.atB);
        visit(FieldInfo{.key = "axis",
                        .unit = "",
                        .meaning = "direction of a slider or wheel, in the world at the start",
                        .minimum = -far,
                        .maximum = far,
                        .geometry = FieldGeometry::worldAxis},
              self.axis);
        visit(FieldInfo{.key = "limited",
                        .unit = "",
                        .meaning =
                            "whether the angle or displacement stays between the lower and the upper limit"},
              self.limited);
        bool const turns = self.form == JointForm::hinge; // limits are angles
        bool const spins = turns || self.form == JointForm::wheel;
        visit(FieldInfo{.key = turns ? "lower_deg" : "lower",
                        .unit = turns ? "rad" : "m",
                        .meaning = "lower limit of the angle or displacement of a against b",
                        .minimum = -far,
                        .maximum = far,
                        .geometry = FieldGeometry::turningLower},
              self.lower);
        visit(FieldInfo{.key = turns ? "upper_deg" : "upper",
                        .unit = turns ? "rad" : "m",
                        .meaning = "upper limit of the angle or displacement of a against b",
                        .minimum = -far,
                        .maximum = far,
                        .geometry = FieldGeometry::turningUpper},
              self.upper);
        visit(FieldInfo{.key = "motor", .unit = "", .meaning = "whether a motor drives the joint"},
              self.motor);
        visit(FieldInfo{.key = spins ? "motor_speed_deg" : "motor_speed",
                        .unit = spins ? "rad/s" : "m/s",
                        .meaning = "target speed of the motor, of a against b",
                        .minimum = -far,
                        .maximum = far,
                        .geometry = FieldGeometry::turning},
              self.motorSpeed);
        visit(FieldInfo{.key = "motor_strength",
                        .unit = spins ? "N m" : "N",
                        .meaning = "greatest torque or force of the motor",
                        .minimum = 0,
                        .maximum = 1e9},
              self.motorStrength);
        visit(FieldInfo{.key = "length",
                        .unit = "m",
                        .meaning = "of a distance, rope or spring; 0: as at the start",
                        .minimum = 0,
                        .maximum = far},
              self.length);
        visit(FieldInfo{.key = "stiffness",
                        .unit = "N/m",
                        .meaning = "spring constant of a spring or wheel",
                        .minimum = 0,
                        .maximum = 1e9},
              self.stiffness);
        visit(FieldInfo{.key = "damping_rate",
                        .unit = "N s/m",
                        .meaning = "damping constant of a spring or wheel",
                        .minimum = 0,
                        .maximum = 1e9},
              self.dampingRate);
        visit(FieldInfo{.key = "ratio",
                        .unit = "",
                        .meaning = "pulley: rope of a + ratio times rope of b is constant; gear: motion of a "
                                   "+ ratio times motion of b is constant",
                        .minimum = -1e3,
                        .maximum = 1e3},
              self.ratio);
        visit(FieldInfo{.key = "ground_a",
                        .unit = "m",
                        .meaning = "point over which a pulley's rope to a runs, in the world",
                        .minimum = -far,
                        .maximum = far,
                        .geometry = FieldGeometry::worldPoint},
              self.groundA);
        visit(FieldInfo{.key = "ground_b",
                        .unit = "m",
                        .meaning = "point over which a pulley's rope to b runs, in the world",
                        .minimum = -far,
                        .maximum = far,
                        .geometry = FieldGeometry::worldPoint},
              self.groundB);
        visit(FieldInfo{.key = "joint_a", .unit = "", .meaning = "hinge or slider of a, for a gear"},
              self.jointA);
        visit(FieldInfo{.key = "joint_b", .unit = "", .meaning = "hinge or slider of b, for a gear"},
              self.jointB);
        visit(FieldInfo{.key = "collide", .unit = "", .meaning = "whether the connected objects can collide"},
              self.collide);
        visit(FieldInfo{.key = "break_force",
                        .unit = "N",
                        .meaning = "force at which the joint breaks; 0: never",
                        .minimum = 0,
                        .maximum = 1e12},
              self.breakForce);
        visit(FieldInfo{.key = "look",
                        .unit = "",
                        .meaning = "how the joint is drawn; own: by its form; it has no other consequences"},
              self.look.drawn);
    }
    friend bool operator==(Joint const&, Joint const&) = default;
};

} // namespace trembler
