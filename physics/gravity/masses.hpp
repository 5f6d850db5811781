// What both levels of gravity between masses start from.
#pragma once

#include "physics/dynamics/body.hpp"
#include "physics/gravity/properties.hpp"
#include "physics/inverse_square/points.hpp"
#include "runtime/placement.hpp"
#include "runtime/property/column.hpp"

namespace trembler {

/// Fills in one entry without a force and one point per object that has a mass and a place, ascending.
void gatherMasses(Column<Mass> const& masses, Column<Position> const& positions, GravityForce& forces,
                  inverse_square::Points& points);

/// Sources of the field and receivers of weight 1 are the same points but for the weights.
void weighReceivers(inverse_square::Points const& sources, inverse_square::Points& receivers);

/// From fields to forces, in place: F = G m g.
void weighFields(GravityLaw const& law, inverse_square::Points const& points, std::vector<Vec2> const& fields,
                 GravityForce& forces);

} // namespace trembler
