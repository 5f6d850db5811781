#include "puzzle/data/effects.hpp"

#include "audio/effect/register.hpp"
#include "physics/register_physics.hpp"
#include "runtime/world/registry.hpp"

namespace trembler {
namespace {

constexpr char const* sound = "sound";

} // namespace

std::set<std::string> dispensableGameEffects() {
    std::set<std::string> names = dispensableEffects();
    names.insert(sound);
    return names;
}

void registerEffects(Registry& registry, std::set<std::string> const& without) {
    std::set<std::string> physics = without;
    bool const silent = physics.erase(sound) > 0;
    registerEverything(registry, physics);
    if (!silent) {
        registerSound(registry);
        return;
    }
    Registry leftOut;
    registerSound(leftOut);
    registry.makeKnown(leftOut);
}

} // namespace trembler
