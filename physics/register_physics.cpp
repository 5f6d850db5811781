#include "physics/register_physics.hpp"

#include "physics/buoyancy/register.hpp"
#include "physics/dynamics/register.hpp"
#include "physics/electricity/register.hpp"
#include "physics/gravity/register.hpp"
#include "physics/look.hpp"
#include "physics/magnetism/register.hpp"
#include "physics/motor/register.hpp"
#include "runtime/population/population_resolver.hpp"
#include "runtime/world/registry.hpp"

namespace trembler {

void registerEverything(Registry& registry) {
    registerRuntime(registry);
    registerDynamics(registry);
    registerElectricity(registry);
    registerGravity(registry);
    registerMagnetism(registry);
    registerBuoyancy(registry);
    registerMotors(registry);
    registerLook(registry);
}

} // namespace trembler
