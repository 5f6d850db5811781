// The input of the levels of gravity between masses.
#pragma once

#include "physics/dynamics/properties/body.hpp"
#include "physics/gravity/properties.hpp"
#include "physics/inverse_square/points.hpp"
#include "runtime/placement.hpp"
#include "runtime/property/column.hpp"

namespace trembler {

/// Fills in one entry without a force and one point per object that has a mass and a place, ascending.
void gatherMasses(Column<Mass> const& masses, Column<Position> const& positions, GravityForce& forces,
                  inverse_square::Points& points);

/// Makes receivers of weight 1 from the sources; only the weights differ.
void weighReceivers(inverse_square::Points const& sources, inverse_square::Points& receivers);

/// The sums over all sources at each receiver.
struct MassSums {
    std::vector<Vec2> fields;      ///< kg/m²
    std::vector<double> stiffness; ///< kg/m³, see inverse_square::addAllPairs()

    void clear(std::size_t count) {
        fields.assign(count, {});
        stiffness.assign(count, 0);
    }
};

/// Computes the forces from the sums, F = G m g, and how fast they vary, ω² = G Σ m / (r² + s²)^(3/2): for
/// two masses that is Kepler's mean motion without the receiver's own mass.
void weighFields(GravityLaw const& law, inverse_square::Points const& points, MassSums const& sums,
                 GravityForce& forces);

} // namespace trembler
