// The distribution of a shape's mass.
#pragma once

#include "physics/dynamics/properties/shape.hpp"

namespace trembler {

/// Of a shape with its mass spread evenly over the area of its pieces; overlaps of pieces count twice.
struct MassProperties {
    double area = 0;           ///< m²
    Vec2 centre;               ///< m, centre of mass in the object's frame
    double inertiaPerMass = 0; ///< m², about the centre of mass
};

/// The shape must be valid (see faultIn()). Circles, boxes and polygons by the usual integrals; a capsule is
/// a box and two half discs, whose centroids lie 4r/3π from their flat sides; pieces are joined by Steiner's
/// theorem.
[[nodiscard]] MassProperties massPropertiesOf(Shape const& shape);

/// The centre of mass in the object's frame, in m. Position is the origin of that frame; the two coincide for
/// every shape that is centred on its origin.
[[nodiscard]] Vec2 centreOfMass(Shape const& shape);

} // namespace trembler
