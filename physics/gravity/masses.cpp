#include "physics/gravity/masses.hpp"

#include "runtime/property/for_each.hpp"

#include <cmath>

namespace trembler {

void gatherMasses(Column<Mass> const& masses, Column<Position> const& positions, GravityForce& forces,
                  inverse_square::Points& points) {
    forces.forces.clear();
    points.clear();
    forEach(
        [&](ObjectId id, Mass const& mass, Position const& position) {
            forces.forces.push_back({id, {}});
            points.add(position.value, mass.value, id.index);
        },
        masses, positions);
}

void weighReceivers(inverse_square::Points const& sources, inverse_square::Points& receivers) {
    receivers = sources;
    receivers.weight.assign(sources.size(), 1);
}

void weighFields(GravityLaw const& law, inverse_square::Points const& points, MassSums const& sums,
                 GravityForce& forces) {
    for (std::size_t i = 0; i < sums.fields.size(); ++i) {
        forces.forces[i].force = law.constant * points.weight[i] * sums.fields[i];
        forces.forces[i].rate = std::sqrt(law.constant * sums.stiffness[i]);
    }
}

} // namespace trembler
