#include "physics/buoyancy/register.hpp"

#include "physics/buoyancy/exact_buoyancy.hpp"
#include "physics/buoyancy/from_gravity.hpp"
#include "physics/buoyancy/liquid_drag.hpp"
#include "physics/buoyancy/liquid_rules.hpp"
#include "physics/buoyancy/particle_buoyancy.hpp"
#include "physics/dynamics/from_buoyancy.hpp"
#include "physics/dynamics/from_liquid_drag.hpp"
#include "runtime/world/registry.hpp"

namespace trembler {
void registerBuoyancy(Registry& registry) {
    registry.rule({.property = &propertyInfo<Liquid>(), .checkAll = checkLiquids});
    registry.component<ExactBuoyancy>();
    registry.component<ParticleBuoyancy>();
    registry.component<LiquidDrag>();
    registry.component<BuoyancyFromGravity>();
    registry.component<DynamicsFromBuoyancy>();
    registry.component<DynamicsFromLiquidDrag>();
}

} // namespace trembler
