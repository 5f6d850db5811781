// The air of a world, and the objects that it acts on.
#pragma once

#include "runtime/property/description.hpp"

namespace trembler {

/// Air is a fluid like those of `Liquid`, without a surface: it is wherever no liquid is. Its pressure grows
/// in the direction of gravity, so it lifts an object by the weight of the air that the object displaces, and
/// it resists motion by the same law as a liquid.
///
/// If a world states its air, the air acts on every movable object. If not, it has the values below and acts
/// only on objects with `InAir`: it would hardly change the motion of other, heavier objects.
struct Air {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{
        "Air", "air",
        "The air, in which light objects rise. If stated, it acts on all movable objects; if not, it is that "
        "of the Earth and acts on light objects only.",
        PropertyPlace::world};
    double density = 1.2; ///< kg/m³: of the Earth at sea level and 20 °C
    double linearDrag = 0.5;
    double quadraticDrag = 1;
    Vec2 wind{};

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "density",
                        .unit = "kg/m³",
                        .meaning = "of the air: 1.2 on Earth, 65 on Venus, 0 where there is none",
                        .minimum = 0,
                        .maximum = 1e4},
              self.density);
        visit(FieldInfo{.key = "linear_drag",
                        .unit = "1/s",
                        .meaning = "drag force divided by the speed and by the mass of the displaced air",
                        .minimum = 0,
                        .maximum = 1e3},
              self.linearDrag);
        visit(FieldInfo{.key = "quadratic_drag",
                        .unit = "",
                        .meaning = "drag coefficient of objects; about 1 for blunt ones",
                        .minimum = 0,
                        .maximum = 1e3},
              self.quadraticDrag);
        visit(FieldInfo{.key = "wind",
                        .unit = "m/s",
                        .meaning = "velocity of the air, the same everywhere",
                        .minimum = -1e3,
                        .maximum = 1e3,
                        .geometry = FieldGeometry::worldVector},
              self.wind);
    }
    friend bool operator==(Air const&, Air const&) = default;
};

/// Marks an object on which air acts also in a world that does not state its air.
struct InAir {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{
        "In air", "in_air",
        "Air lifts and slows down the object also if the world does not state its air. If not stated, this "
        "is true for objects that are less than ten times as dense as the Earth's air."};
};

} // namespace trembler
