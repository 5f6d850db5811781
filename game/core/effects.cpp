#include "game/core/effects.hpp"

#include "audio/effect/register.hpp"
#include "physics/register_physics.hpp"

namespace trembler {

void registerEffects(Registry& registry) {
    registerEverything(registry);
    registerSound(registry);
}

} // namespace trembler
