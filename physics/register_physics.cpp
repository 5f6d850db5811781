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

#include <fmt/format.h>

#include <stdexcept>

namespace trembler {
namespace {

struct Effect {
    char const* name;
    void (*registerAll)(Registry&);
};

// The order is part of the simulation.
constexpr Effect effects[] = {
    {.name = "electricity", .registerAll = registerElectricity},
    {.name = "gravity", .registerAll = registerGravity},
    {.name = "magnetism", .registerAll = registerMagnetism},
    {.name = "buoyancy", .registerAll = registerBuoyancy},
    {.name = "motor", .registerAll = registerMotors},
};

} // namespace

std::set<std::string> const& dispensableEffects() {
    static std::set<std::string> const names = [] {
        std::set<std::string> found;
        for (Effect const& effect : effects) {
            found.insert(effect.name);
        }
        return found;
    }();
    return names;
}

void registerEverything(Registry& registry, std::set<std::string> const& without) {
    for (std::string const& name : without) {
        if (!dispensableEffects().contains(name)) {
            throw std::invalid_argument(fmt::format("there is no effect '{}' to be left out", name));
        }
    }
    registerRuntime(registry);
    registerDynamics(registry);
    for (Effect const& effect : effects) {
        if (!without.contains(effect.name)) {
            effect.registerAll(registry);
            continue;
        }
        Registry leftOut;
        effect.registerAll(leftOut);
        registry.makeKnown(leftOut);
    }
    registerMaterial(registry);
    registerLook(registry);
}

} // namespace trembler
