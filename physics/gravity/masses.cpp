#include "physics/gravity/masses.hpp"

#include "runtime/property/for_each.hpp"

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

void weighFields(GravityLaw const& law, inverse_square::Points const& points, std::vector<Vec2> const& fields,
                 GravityForce& forces) {
    for (std::size_t i = 0; i < fields.size(); ++i) {
        forces.forces[i].force = law.constant * points.weight[i] * fields[i];
    }
}

} // namespace trembler
