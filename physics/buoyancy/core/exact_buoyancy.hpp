// Buoyancy, detail level "exact".
#pragma once

#include "physics/buoyancy/core/buoyancy_resolver.hpp"
#include "physics/buoyancy/hulls/exact_hull.hpp"

namespace trembler {

class ExactBuoyancy final : public BuoyancyResolver<ExactBuoyancy> {
public:
    static constexpr ComponentText text{
        .name = "Buoyancy",
        .effect = "buoyancy",
        .level = "exact",
        .work = "Calculates the centre of buoyancy and F_B from area and centroid of the part of each object "
                "that is in a liquid or in air, and exports them as per-object properties.",
        .rank = 1};

    Flotation::HullMaker prepare(Access&, Flotation&) const {
        return [](Shape const& shape) { return std::make_unique<ExactHull>(shape); };
    }
};

} // namespace trembler
