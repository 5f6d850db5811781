// The resistance of liquids to motion: derived by Liquid Drag, passed on to Dynamics.
#pragma once

#include "runtime/math/vec2.hpp"
#include "runtime/object/object_id.hpp"
#include "runtime/property/description.hpp"
#include "runtime/trace/event.hpp"

#include <vector>

namespace trembler {

/// The resistance to the motion of each immersed object, as coefficients of velocities and not as forces: so
/// an engine can integrate it without overshooting, however light the objects are. Ascending by object.
struct LiquidResistance {
    static constexpr PropertyKind kind = PropertyKind::derived;
    static constexpr PropertyText text{"Liquid resistance", "liquid_resistance",
                                       "The resistance to the motion of each object in a liquid."};
    struct Entry {
        ObjectId object;
        Vec2 point;         ///< m, in the world, where it acts
        double xx = 0;      ///< kg/s: force against the point's velocity,
        double xy = 0;      ///< kg/s  a symmetric matrix
        double yy = 0;      ///< kg/s
        double angular = 0; ///< kg m²/s: torque against the angular velocity
        Vec2 push;          ///< N: added by a current, at the point
        double rate = 0;    ///< 1/s, at which F_B varies as the object moves: stated here, because this
                            ///< resistance determines whether F_B is foreseen; see StateRate
        EventId event;      ///< "enters the liquid"; none without tracing
        template <class Self, class Visitor>
        static void describe(Self& self, Visitor&& visit) {
            visit(FieldInfo{.key = "object", .unit = "", .meaning = "object whose motion is resisted"},
                  self.object);
            visit(FieldInfo{.key = "point",
                            .unit = "m",
                            .meaning = "point of the world at which the resistance acts"},
                  self.point);
            visit(FieldInfo{.key = "xx",
                            .unit = "kg/s",
                            .meaning = "force against the velocity of the point, along x"},
                  self.xx);
            visit(FieldInfo{.key = "xy",
                            .unit = "kg/s",
                            .meaning = "force along x against the velocity along y, and the reverse"},
                  self.xy);
            visit(FieldInfo{.key = "yy",
                            .unit = "kg/s",
                            .meaning = "force against the velocity of the point, along y"},
                  self.yy);
            visit(FieldInfo{.key = "angular",
                            .unit = "kg m²/s",
                            .meaning = "torque against the angular velocity"},
                  self.angular);
            visit(FieldInfo{.key = "push", .unit = "N", .meaning = "force that a current adds"}, self.push);
            visit(FieldInfo{.key = "rate",
                            .unit = "1/s",
                            .meaning = "at which the buoyancy force varies as the object moves"},
                  self.rate);
        }
    };
    std::vector<Entry> entries;
    bool foreseen = false; ///< whether the entries allow for the change of F_B until it is computed again

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "entries", .unit = "", .meaning = "ascending by object"}, self.entries);
        visit(FieldInfo{.key = "foreseen",
                        .unit = "",
                        .meaning = "whether they allow for the change of the buoyancy force until they are "
                                   "computed again"},
              self.foreseen);
    }
};

} // namespace trembler
