// What makes an object a body of liquid.
#pragma once

#include "runtime/property/description.hpp"

namespace trembler {

/// Flags an object to be a body of liquid (6.13.1). Its shape, where it stands and as it is turned, is the
/// liquid's area, its top side the surface; its density is the liquid's. It never moves and nothing collides
/// with it.
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
                        .meaning = "of what a body displaces: the share of its momentum lost per second",
                        .minimum = 0,
                        .maximum = 1e3},
              self.linearDrag);
        visit(FieldInfo{.key = "quadratic_drag",
                        .unit = "",
                        .meaning = "drag coefficient of what is immersed; about 1 for blunt bodies",
                        .minimum = 0,
                        .maximum = 1e3},
              self.quadraticDrag);
        visit(FieldInfo{.key = "current",
                        .unit = "m/s",
                        .meaning = "velocity of the liquid, in the world",
                        .minimum = -1e3,
                        .maximum = 1e3},
              self.current);
    }
    friend bool operator==(Liquid const&, Liquid const&) = default;
};

} // namespace trembler
