// The property of a body of liquid.
#pragma once

#include "runtime/property/description.hpp"

namespace trembler {

/// Flags an object to be a body of liquid (6.13.1). Its shape, placed and turned as the object, is the
/// liquid's area; its density is the liquid's. It never moves and has no collisions.
///
/// The surface faces the object's own y axis, so a liquid that is turned has a tilted surface. The pressure
/// is equal everywhere on the surface, so it grows at right angles to the surface: with density times the
/// component of gravity that points into the liquid. With a level surface that is Archimedes' principle, eq.
/// 6.1; along a tilted surface objects slide down, as on a river. (A force against gravity under a tilted
/// surface could not come from any pressure, and would keep wheels turning for ever.)
struct Liquid {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{
        "Liquid", "liquid",
        "The object is a body of liquid: its shape is the liquid's area, and nothing collides with it."};
    double linearDrag = 1.5;
    double quadraticDrag = 1;
    Vec2 current;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "linear_drag",
                        .unit = "1/s",
                        .meaning = "drag force divided by the speed and by the mass of the displaced liquid",
                        .minimum = 0,
                        .maximum = 1e3},
              self.linearDrag);
        visit(FieldInfo{.key = "quadratic_drag",
                        .unit = "",
                        .meaning = "drag coefficient of immersed bodies; about 1 for blunt ones",
                        .minimum = 0,
                        .maximum = 1e3},
              self.quadraticDrag);
        visit(FieldInfo{.key = "current",
                        .unit = "m/s",
                        .meaning = "velocity of the liquid, in the world",
                        .minimum = -1e3,
                        .maximum = 1e3,
                        .geometry = FieldGeometry::worldVector},
              self.current);
    }
    friend bool operator==(Liquid const&, Liquid const&) = default;
};

} // namespace trembler
