// How hard something is to turn.
#pragma once

#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "runtime/property/column.hpp"

namespace trembler {

/// Moment of inertia (kg m²) about its centre of mass; infinite for a fixed object, 0 for one that is no
/// body. Masses of parts that are joined to it do not count, so it is never too large.
[[nodiscard]] double inertiaOf(ObjectId object, Column<Mass> const& masses, Column<Shape> const& shapes,
                               Column<Fixed> const& fixed);

} // namespace trembler
