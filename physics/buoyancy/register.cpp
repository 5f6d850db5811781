#include "physics/buoyancy/register.hpp"

#include "physics/buoyancy/core/exact_buoyancy.hpp"
#include "physics/buoyancy/core/liquid_drag.hpp"
#include "physics/buoyancy/core/particle_buoyancy.hpp"
#include "physics/buoyancy/interactions/from_gravity.hpp"
#include "physics/buoyancy/rules/air_completion.hpp"
#include "physics/buoyancy/rules/liquid_rules.hpp"
#include "physics/dynamics/interactions/from_buoyancy.hpp"
#include "physics/dynamics/interactions/from_liquid_drag.hpp"
#include "runtime/world/registry.hpp"

namespace trembler {
void registerBuoyancy(Registry& registry) {
    registry.rule({.property = &propertyInfo<Liquid>(), .checkAll = checkLiquids});
    registry.completion<AirCompletion>();
    registry.component<ExactBuoyancy>();
    registry.component<ParticleBuoyancy>();
    registry.component<LiquidDrag>();
    registry.component<BuoyancyFromGravity>();
    registry.component<DynamicsFromBuoyancy>();
    registry.component<DynamicsFromLiquidDrag>();
}

} // namespace trembler
