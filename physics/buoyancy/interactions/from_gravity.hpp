// (Buoyancy <- Gravity): buoyancy uses the world's linear gravity (6.13.2).
#pragma once

#include "physics/buoyancy/calls.hpp"
#include "physics/gravity/properties.hpp"
#include "runtime/component/interaction.hpp"
#include "runtime/property/for_each.hpp"

namespace trembler {

class BuoyancyFromGravity final : public Interaction<BuoyancyFromGravity, BuoyancyRole, Reads<GravityField>> {
public:
    static constexpr ComponentText text{.name = "Buoyancy <- Gravity",
                                        .effect = "buoyancy",
                                        .level = "",
                                        .work = "Feeds the world's linear gravity vector to buoyancy."};
    using Activation = NeedsAll<GravityField>;
    static constexpr bool inSetup = true; // otherwise floating objects would fall for one frame
    void apply(Access& access) {
        forEach(
            [&](ObjectId id, GravityField const& field) {
                access.call(SetLinearGravity{id, field.acceleration});
            },
            access.read<GravityField>());
    }
};

} // namespace trembler
