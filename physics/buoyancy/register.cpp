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
namespace {

// Interactions first speak at the end of the first frame. Until then buoyancy knows the gravity that the
// world begins with, or whatever floats would fall for a frame before it is held.
void startGravity(Store& store, ObjectId id) {
    if (GravityField const* const field = store.column<GravityField>().find(id)) {
        store.slot<LinearGravityVector>().value().gravity += field->acceleration;
    }
}

} // namespace

void registerBuoyancy(Registry& registry) {
    registry.completion(startGravity);
    registry.rule({&propertyInfo<Liquid>(), checkLiquid});
    registry.component<ExactBuoyancy>();
    registry.component<ParticleBuoyancy>();
    registry.component<LiquidDrag>();
    registry.component<BuoyancyFromGravity>();
    registry.component<DynamicsFromBuoyancy>();
    registry.component<DynamicsFromLiquidDrag>();
}

} // namespace trembler
