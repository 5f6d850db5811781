#include "physics/gravity/real_gravity.hpp"

#include "runtime/property/for_each.hpp"

namespace trembler {

void RealGravity::update(Access& access) {
    GravityLaw const law = access.read<GravityLaw>().values().front();
    double const softeningSquared = law.softening * law.softening;
    auto& forces = access.derive<GravityForce>().forces;
    forces.clear();
    places_.clear();
    masses_.clear();
    forEach(
        [&](ObjectId id, Mass const& mass, Position const& position) {
            forces.push_back({id, {}});
            places_.push_back(position.value);
            masses_.push_back(mass.value);
        },
        access.read<Mass>(), access.read<Position>());
    // Every object sums over all others by itself: twice the work of sharing each pair, but the order of
    // additions, and so every bit, is the same on any number of threads.
    access.forRanges(forces.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Vec2 field;
            for (std::size_t j = 0; j < places_.size(); ++j) {
                Vec2 const r = places_[j] - places_[i];
                double const d2 = lengthSquared(r) + softeningSquared;
                field += (masses_[j] / (d2 * std::sqrt(d2))) * r; // zero for itself
            }
            forces[i].force = law.constant * masses_[i] * field;
        }
    });
}

} // namespace trembler
