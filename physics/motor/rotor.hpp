// The moment of inertia of rotors.
#pragma once

#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "runtime/property/column.hpp"

namespace trembler {

/// Moment of inertia (kg m²) about its centre of mass; infinite for a fixed object, 0 for an object without a
/// body. Masses of joined parts do not count, so it is never too large.
[[nodiscard]] double inertiaOf(ObjectId object, Column<Mass> const& masses, Column<Shape> const& shapes,
                               Column<Fixed> const& fixed);

} // namespace trembler
