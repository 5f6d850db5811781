#include "physics/motor/rotor.hpp"

#include "physics/dynamics/properties/shapes/mass_properties.hpp"

#include <limits>

namespace trembler {

double inertiaOf(ObjectId object, Column<Mass> const& masses, Column<Shape> const& shapes,
                 Column<Fixed> const& fixed) {
    if (!object.valid() || fixed.has(object)) {
        return std::numeric_limits<double>::infinity();
    }
    Mass const* const mass = masses.find(object);
    Shape const* const shape = shapes.find(object);
    if (mass == nullptr || shape == nullptr || shape->pieces.empty()) {
        return 0;
    }
    return mass->value * massPropertiesOf(*shape).inertiaPerMass;
}

} // namespace trembler
