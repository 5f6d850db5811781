// The resolver properties of Buoyancy (6.13.2).
#pragma once

#include "physics/buoyancy/properties/moments.hpp"
#include "physics/buoyancy/properties/waterline.hpp"
#include "runtime/property/coverage.hpp"
#include "runtime/property/description.hpp"
#include "runtime/trace/event.hpp"

#include <algorithm>
#include <vector>

namespace trembler {

/// The linear gravity vector, as (Buoyancy <- Gravity) has set it.
struct LinearGravityVector {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{"Linear gravity vector", "linear_gravity",
                                       "The acceleration due to gravity that buoyancy uses."};
    static constexpr Coverage coverage = hashed;
    static constexpr std::string_view standing = "the latest gravity received";
    Vec2 gravity; ///< m/s²

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value", .unit = "m/s²", .meaning = "acceleration"}, self.gravity);
    }
};

/// F_B: one entry per object that displaces any liquid, ascending.
struct BuoyancyForce {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{
        "F_B", "buoyancy_force", "The buoyancy force on each object: the weight of the displaced liquid."};
    static constexpr Coverage coverage = derivedFrom("Immersion and Linear gravity vector");
    static constexpr std::string_view standing = "the forces that act";
    struct Entry {
        ObjectId object;
        Vec2 force;    ///< N, acts at the centre of buoyancy
        EventId event; ///< "enters the liquid"; none without tracing
        friend bool operator==(Entry const&, Entry const&) = default;
        template <class Self, class Visitor>
        static void describe(Self& self, Visitor&& visit) {
            visit(FieldInfo{.key = "object", .unit = "", .meaning = "object on which it acts"}, self.object);
            visit(FieldInfo{.key = "force", .unit = "N", .meaning = "at the centre of buoyancy"}, self.force);
        }
    };
    std::vector<Entry> forces;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "forces", .unit = "", .meaning = "ascending by object"}, self.forces);
    }
};

/// The centres of buoyancy: the centres of mass of the displaced liquids. Entries as in BuoyancyForce.
struct CentreOfBuoyancy {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{"COB", "centre_of_buoyancy",
                                       "The centre of buoyancy of each object: where F_B acts."};
    static constexpr Coverage coverage = derivedFrom("Immersion");
    static constexpr std::string_view standing = "the points at which the forces act";
    struct Entry {
        ObjectId object;
        Vec2 centre; ///< m, in the object's frame
        Vec2 world;  ///< m, in the world when it was computed
        friend bool operator==(Entry const&, Entry const&) = default;
        template <class Self, class Visitor>
        static void describe(Self& self, Visitor&& visit) {
            visit(FieldInfo{.key = "object", .unit = "", .meaning = "object whose centre it is"},
                  self.object);
            visit(FieldInfo{.key = "centre", .unit = "m", .meaning = "in the frame of the object"},
                  self.centre);
            visit(FieldInfo{.key = "world", .unit = "m", .meaning = "in the world"}, self.world);
        }
    };
    std::vector<Entry> centres;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "centres", .unit = "", .meaning = "ascending by object"}, self.centres);
    }
};

/// The area of each liquid that each object displaces; ascending by object, then by liquid.
struct Immersions {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{"Immersion", "immersion",
                                       "The part of each object that is in each liquid."};
    static constexpr Coverage coverage =
        derivedFrom("shapes, positions and rotations of liquids and of the objects in them");
    static constexpr std::string_view standing = "the immersed parts of objects";
    struct Entry {
        ObjectId object;
        ObjectId liquid;     ///< invalid: the air
        double density = 0;  ///< kg/m³, of the liquid
        Vec2 up;             ///< unit, in the world, out of the liquid's surface
        AreaMoments wet;     ///< of the immersed part, in the object's frame
        Waterline waterline; ///< in the object's frame
        EventId event;       ///< "enters the liquid"; none without tracing
        template <class Self, class Visitor>
        static void describe(Self& self, Visitor&& visit) {
            visit(FieldInfo{.key = "object", .unit = "", .meaning = "which is in the liquid"}, self.object);
            visit(FieldInfo{.key = "liquid", .unit = "", .meaning = "the liquid; none: the air"},
                  self.liquid);
            visit(FieldInfo{.key = "density", .unit = "kg/m³", .meaning = "of the liquid"}, self.density);
            visit(FieldInfo{.key = "up", .unit = "", .meaning = "out of the surface of the liquid"}, self.up);
            visit(FieldInfo{.key = "area", .unit = "m²", .meaning = "of the immersed part"}, self.wet.area);
        }
    };
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "entries", .unit = "", .meaning = "ascending by object, then by liquid"},
              self.entries);
    }

    std::vector<Entry> entries;
    double interval = 0; ///< s, for which these results are held: the resolver's period

    /// The growth of the pressure in the liquid per depth and density: m/s².
    [[nodiscard]] static double pull(Entry const& entry, Vec2 gravity) {
        return std::max(0.0, -dot(gravity, entry.up));
    }
};

} // namespace trembler
