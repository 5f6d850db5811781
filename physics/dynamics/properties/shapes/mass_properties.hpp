// The mass of a shape, its density and its distribution.
#pragma once

#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/shape.hpp"

namespace trembler {

/// The distribution of a mass that is spread evenly over the area of a shape's pieces; overlaps count twice.
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

/// The mass in kg of an object of that shape: its density (1000 kg/m³ if null) times its area times the depth
/// of the world, from 1e-6 to 1e9 kg.
[[nodiscard]] double massFromDensity(Shape const& shape, Density const* density);

/// The density of an object in kg/m³: its mass divided by its volume, which is its area times the depth of
/// the world. So a stated mass takes precedence over a stated density and over that of the material. If the
/// mass follows from the density, or is null, it is that density, to the last bit; without any, 1000 kg/m³.
[[nodiscard]] double densityOf(Shape const& shape, Mass const* mass, Density const* density);

} // namespace trembler
