#include "physics/gravity/register.hpp"

#include "physics/dynamics/interactions/from_gravity.hpp"
#include "physics/gravity/linear_gravity.hpp"
#include "physics/gravity/real_gravity.hpp"
#include "physics/gravity/tree_gravity.hpp"
#include "runtime/world/registry.hpp"

namespace trembler {

void registerGravity(Registry& registry) {
    registry.component<LinearGravity>();
    registry.component<RealGravity>();
    registry.component<TreeGravity>();
    registry.component<DynamicsFromGravity>();
    registry.shortcut<DynamicsFromGravity, LinearGravity>();
}

} // namespace trembler
