#include "physics/register_physics.hpp"

#include "physics/gravity/register.hpp"
#include "physics/magnetism/register.hpp"
#include "runtime/population/population_resolver.hpp"
#include "runtime/world/registry.hpp"

namespace trembler {

void registerEverything(Registry& registry) {
    registerRuntime(registry);
    // registerDynamics and registerElectricity belong here, in this order, before the others.
    registerGravity(registry);
    registerMagnetism(registry);
}

} // namespace trembler
