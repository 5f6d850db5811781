// Motors and generators as properties of a rotor: the cheap version that 6.10.4 recommends for a game that
// needs many of them.
#pragma once

#include "runtime/property/description.hpp"

namespace trembler {

/// While the object is part of a working circuit a torque turns it, like the rotor of a direct-current motor:
/// the whole torque at rest, less the faster it turns, and none at its idling speed.
struct ElectricMotor {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Electric motor", "electric_motor",
                                       "Drives the object's rotation while the object is on."};
    double torque = 0;    ///< N m at rest; above zero: anticlockwise
    double idleSpeed = 0; ///< rad/s, in either direction; 0: none, the torque is constant
    ObjectId against;     ///< receives the reaction, and speed is relative to it; invalid: the world

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "torque",
                        .unit = "N m",
                        .meaning = "torque at rest; above 0: anticlockwise",
                        .minimum = -1e9,
                        .maximum = 1e9,
                        .required = true,
                        .geometry = FieldGeometry::turning},
              self.torque);
        visit(FieldInfo{.key = "idle_speed_deg",
                        .unit = "rad/s",
                        .meaning = "speed at which the torque has fallen to zero; 0: the torque is constant",
                        .minimum = 0,
                        .maximum = 1e4,
                        .geometry = FieldGeometry::invariant},
              self.idleSpeed);
        visit(FieldInfo{.key = "against",
                        .unit = "",
                        .meaning = "object that bears the reaction; left out: the world"},
              self.against);
    }
};

/// While the object turns it is connected to a source of electricity, and so "emits" power (6.10.4); while a
/// current flows through it, it resists turning. Induction is not part of this effect.
struct Generator {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Generator", "generator",
                                       "Supplies electricity while the object turns."};
    ObjectId source;    ///< the electrical source that it is connected to while it turns
    double speed = 1;   ///< rad/s, in either direction, from which on it is connected
    double braking = 0; ///< N m against its turning while current flows through it

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "source",
                        .unit = "",
                        .meaning = "the electrical source that it is connected to while it turns",
                        .required = true},
              self.source);
        visit(FieldInfo{.key = "speed_deg",
                        .unit = "rad/s",
                        .meaning = "speed from which on it supplies electricity, in either direction",
                        .minimum = 1e-3,
                        .maximum = 1e4,
                        .geometry = FieldGeometry::invariant},
              self.speed);
        visit(FieldInfo{.key = "braking",
                        .unit = "N m",
                        .meaning = "braking torque while current flows through it",
                        .minimum = 0,
                        .maximum = 1e9},
              self.braking);
    }
};

} // namespace trembler
