// The properties of a rigid body.
#pragma once

#include "runtime/property/description.hpp"

#include <array>
#include <vector>

namespace trembler {

struct Mass {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{
        "Mass", "mass", "The mass of the object. Where none is stated it follows from the density."};
    double value = 1;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(
            FieldInfo{.key = "value", .unit = "kg", .meaning = "whole mass", .minimum = 1e-6, .maximum = 1e9},
            self.value);
    }
};

struct Density {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Density", "density", "The density of the object."};
    double value = 1000;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value",
                        .unit = "kg/m³",
                        .meaning = "in a world that is 0.1 m deep",
                        .minimum = 1e-3,
                        .maximum = 1e6},
              self.value);
    }
};

struct Friction {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{
        "Friction", "friction", "Coulomb's coefficient of the surface; a pair has the geometric mean."};
    double coefficient = 0.5;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value", .unit = "", .meaning = "coefficient", .minimum = 0, .maximum = 100},
              self.coefficient);
    }
};

struct Restitution {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{
        "Restitution", "restitution",
        "Speed after an impact over speed before it; a pair has the larger one."};
    double coefficient = 0;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value",
                        .unit = "",
                        .meaning = "0: none of it, 1: all of it",
                        .minimum = 0,
                        .maximum = 1},
              self.coefficient);
    }
};

/// Marks an object that never moves.
struct Fixed {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Fixed", "fixed", "The object is a static part of the world."};
};

/// Marks a body that is so fast that it would otherwise jump through thin movable bodies.
struct Bullet {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Bullet", "bullet",
                                       "The object's path, not only its places, is tested for hits."};
};

/// Which objects can collide: two do if each one's category is in the other's mask, unless both share a group
/// other than 0: then they collide if it is positive and never if it is negative.
struct CollisionGroups {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Collision groups", "collision", "Which objects this one can hit."};
    std::int32_t category = 1;
    std::int32_t mask = 0xffff;
    std::int32_t group = 0;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "category", .unit = "", .meaning = "bit set", .minimum = 0, .maximum = 0xffff},
              self.category);
        visit(FieldInfo{.key = "mask",
                        .unit = "",
                        .meaning = "bit set of categories that it hits",
                        .minimum = 0,
                        .maximum = 0xffff},
              self.mask);
        visit(FieldInfo{.key = "group",
                        .unit = "",
                        .meaning = "overrules the two if shared and not 0",
                        .minimum = -32768,
                        .maximum = 32767},
              self.group);
    }
    friend bool operator==(CollisionGroups const&, CollisionGroups const&) = default;
};

/// Whether two objects with these groups can hit each other. An object without the property has the default
/// groups.
[[nodiscard]] constexpr bool canHit(CollisionGroups const& a, CollisionGroups const& b) {
    if (a.group != 0 && a.group == b.group) {
        return a.group > 0;
    }
    return (a.category & b.mask) != 0 && (b.category & a.mask) != 0;
}

/// How strongly a body's motion is damped.
struct Damping {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Damping", "damping", "How strongly motion dies away by itself."};
    double linear = 0;
    double angular = 0;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(
            FieldInfo{
                .key = "linear", .unit = "1/s", .meaning = "of the velocity", .minimum = 0, .maximum = 1e3},
            self.linear);
        visit(
            FieldInfo{
                .key = "angular", .unit = "1/s", .meaning = "of the turning", .minimum = 0, .maximum = 1e3},
            self.angular);
    }
    friend bool operator==(Damping const&, Damping const&) = default;
};

} // namespace trembler
