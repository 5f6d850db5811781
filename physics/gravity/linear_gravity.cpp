#include "physics/gravity/linear_gravity.hpp"

#include "runtime/property/for_each.hpp"
#include "runtime/world/store.hpp"

namespace trembler {

bool LinearGravity::faithful(Store const& store) {
    auto const* const laws = store.findColumn<GravityLaw>();
    return laws == nullptr || laws->empty();
}

void LinearGravity::update(Access& access) {
    Vec2 const acceleration = access.read<GravityField>().values().front().acceleration;
    auto const& masses = access.read<Mass>();
    auto& forces = access.derive<GravityForce>().forces;
    forces.clear();
    forEach(
        [&](ObjectId id, Mass const& mass) {
            forces.push_back({id, mass.value * acceleration});
        },
        masses);
}

} // namespace trembler
