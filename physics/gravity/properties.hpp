// The properties of gravity: of the world and of objects.
#pragma once

#include "runtime/property/description.hpp"

#include <vector>

namespace trembler {

/// m/s². New levels and the measurements of hard cases use it; simulations read the gravity of their world.
inline constexpr double earthGravity = 9.81;

/// The world's gravity: a level on Mars changes one number (3.3.3).
struct GravityField {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Gravity", "gravity",
                                       "The acceleration due to gravity, the same everywhere in the world.",
                                       PropertyPlace::world};
    Vec2 acceleration;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value",
                        .unit = "m/s²",
                        .meaning = "[0, -9.81] on Earth",
                        .minimum = -1e4,
                        .maximum = 1e4,
                        .geometry = FieldGeometry::worldVector},
              self.acceleration);
    }
};

/// The world's law of attraction between masses, for real gravity.
struct GravityLaw {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Law of gravity", "gravity_law",
                                       "How masses attract one another under real gravity.",
                                       PropertyPlace::world};
    double constant = 6.6743e-11;
    double softening = 0.01;
    double openingAngle = 0.35;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "constant",
                        .unit = "N m²/kg²",
                        .meaning = "gravitational constant; 6.6743e-11 in reality",
                        .minimum = 0,
                        .maximum = 1e12},
              self.constant);
        visit(FieldInfo{.key = "softening",
                        .unit = "m",
                        .meaning = "length that keeps the force finite at zero distance",
                        .minimum = 1e-6,
                        .maximum = 1e6},
              self.softening);
        visit(FieldInfo{.key = "opening_angle",
                        .unit = "",
                        .meaning = "at the detail level \"tree\": a cluster acts as one mass if its radius "
                                   "divided by its distance is below this; 0: never",
                        .minimum = 0,
                        .maximum = 1,
                        .accuracy = {0, 1}},
              self.openingAngle);
    }
};

/// F_G. One entry per object with a mass, ascending, including fixed objects.
struct GravityForce {
    static constexpr PropertyKind kind = PropertyKind::derived;
    static constexpr PropertyText text{"F_G", "gravity_force", "The force due to gravity on each object."};
    struct Entry {
        ObjectId object;
        Vec2 force;      ///< N, at the centre of mass
        double rate = 0; ///< 1/s, at which the force varies as the object moves; see StateRate
        template <class Self, class Visitor>
        static void describe(Self& self, Visitor&& visit) {
            visit(FieldInfo{.key = "object", .unit = "", .meaning = "object on which it acts"}, self.object);
            visit(FieldInfo{.key = "force", .unit = "N", .meaning = "at the centre of mass"}, self.force);
            visit(FieldInfo{.key = "rate",
                            .unit = "1/s",
                            .meaning = "rate at which the force varies as the object moves"},
                  self.rate);
        }
    };
    std::vector<Entry> forces;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "forces", .unit = "", .meaning = "ascending by object"}, self.forces);
    }
};

} // namespace trembler
