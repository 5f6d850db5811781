#include "physics/register_physics.hpp"

#include "runtime/population/population_resolver.hpp"
#include "runtime/world/registry.hpp"

namespace trembler {

void registerEverything(Registry& registry) {
    registerRuntime(registry);
}

} // namespace trembler
