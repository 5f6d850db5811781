// Buoyancy, detail level "particles".
#pragma once

#include "physics/buoyancy/core/buoyancy_resolver.hpp"
#include "physics/buoyancy/hulls/particle_hull.hpp"
#include "physics/buoyancy/properties/settings.hpp"

namespace trembler {

class ParticleBuoyancy final : public BuoyancyResolver<ParticleBuoyancy, BuoyancySettings> {
public:
    static constexpr ComponentText text{
        .name = "Particle Buoyancy",
        .effect = "buoyancy",
        .level = "particles",
        .work =
            "Calculates the centre of buoyancy and F_B as sums over particles that represent each object, "
            "and exports them as per-object properties.",
        .rank = 2}; // 64 particles cost more than an exact box

    Flotation::HullMaker prepare(Access& access, Flotation& flotation) {
        auto const& all = access.read<BuoyancySettings>();
        int const count = (all.empty() ? BuoyancySettings{} : all.values().front()).particles;
        if (count != count_) {
            count_ = count;
            flotation.forgetHulls();
        }
        return [count](Shape const& shape) { return std::make_unique<ParticleHull>(shape, count); };
    }

private:
    int count_ = 0;
};

} // namespace trembler
