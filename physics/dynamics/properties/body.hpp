// The properties of a rigid body.
#pragma once

#include "runtime/property/description.hpp"

#include <array>
#include <vector>

namespace trembler {

struct Mass {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Mass", "mass",
                                       "The mass of the object. If not stated, it follows from the density."};
    double value = 1;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value",
                        .unit = "kg",
                        .meaning = "mass of the whole object",
                        .minimum = 1e-6,
                        .maximum = 1e9},
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
                        .meaning = "mass per volume; the world is 0.1 m deep",
                        .minimum = 1e-3,
                        .maximum = 1e6},
              self.value);
    }
};

struct Friction {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{
        "Friction", "friction",
        "Coulomb's coefficient of friction of the surface; two objects have the geometric mean of theirs."};
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
        "Speed after an impact divided by the speed before it; two objects have the larger one of theirs."};
    double coefficient = 0;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value",
                        .unit = "",
                        .meaning = "0: no bounce; 1: no loss of speed",
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
                                       "Collisions are found along the object's path, not only at its "
                                       "position in each step: for fast, small objects."};
};

/// Which objects can collide. If two objects share a group other than 0, they collide if it is positive, and
/// never if it is negative. Otherwise they collide if each one's category is in the other's mask.
struct CollisionGroups {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Collision groups", "collision",
                                       "Which objects this one can collide with."};
    std::int32_t category = 1;
    std::int32_t mask = 0xffff;
    std::int32_t group = 0;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "category",
                        .unit = "",
                        .meaning = "bit set of the object's own categories",
                        .minimum = 0,
                        .maximum = 0xffff},
              self.category);
        visit(FieldInfo{.key = "mask",
                        .unit = "",
                        .meaning = "bit set of the categories that it collides with",
                        .minimum = 0,
                        .maximum = 0xffff},
              self.mask);
        visit(FieldInfo{.key = "group",
                        .unit = "",
                        .meaning = "two objects of the same group always collide if it is above 0, never if "
                                   "it is below 0; 0: category and mask apply",
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
    static constexpr PropertyText text{"Damping", "damping", "How fast motion decays by itself."};
    double linear = 0;
    double angular = 0;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "linear",
                        .unit = "1/s",
                        .meaning = "rate at which the velocity decays",
                        .minimum = 0,
                        .maximum = 1e3},
              self.linear);
        visit(FieldInfo{.key = "angular",
                        .unit = "1/s",
                        .meaning = "rate at which the angular velocity decays",
                        .minimum = 0,
                        .maximum = 1e3},
              self.angular);
    }
    friend bool operator==(Damping const&, Damping const&) = default;
};

} // namespace trembler
