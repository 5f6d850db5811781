// Positions, angles and velocities: properties that a level file states for every placed object, independent
// of its physics.
#pragma once

#include "runtime/property/description.hpp"
#include "runtime/property/state_hash.hpp"

namespace trembler {

struct Position {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Position", "at", "The X and Y coordinates of the object.",
                                       PropertyPlace::placement};
    Vec2 value;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value",
                        .unit = "m",
                        .meaning = "centre of the object",
                        .minimum = -1e6,
                        .maximum = 1e6,
                        .geometry = FieldGeometry::worldPoint},
              self.value);
    }
};

struct Rotation {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{
        "Rotation", "angle_deg", "An angle describing the rotation of the object.", PropertyPlace::placement};
    double angle = 0;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value",
                        .unit = "rad",
                        .meaning = "anticlockwise from the x axis",
                        .minimum = -1e6,
                        .maximum = 1e6,
                        .geometry = FieldGeometry::heading},
              self.angle);
    }
};

struct Velocity {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Velocity", "velocity",
                                       "A vector indicating the current velocity of the object."};
    Vec2 value;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value",
                        .unit = "m/s",
                        .meaning = "of the centre of mass",
                        .minimum = -1e4,
                        .maximum = 1e4,
                        .geometry = FieldGeometry::worldVector},
              self.value);
    }
};

struct AngularVelocity {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Angular Velocity", "angular_velocity_deg",
                                       "A single number describing the angular velocity of the object."};
    double value = 0;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value",
                        .unit = "rad/s",
                        .meaning = "anticlockwise",
                        .minimum = -1e4,
                        .maximum = 1e4,
                        .geometry = FieldGeometry::turning},
              self.value);
    }
};

template <>
inline constexpr bool hashableAsBytes<Position> = true;
template <>
inline constexpr bool hashableAsBytes<Rotation> = true;
template <>
inline constexpr bool hashableAsBytes<Velocity> = true;
template <>
inline constexpr bool hashableAsBytes<AngularVelocity> = true;

} // namespace trembler
