#include "physics/register_physics.hpp"

#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/buoyancy/properties/settings.hpp"
#include "physics/buoyancy/register.hpp"
#include "physics/dynamics/register.hpp"
#include "physics/electricity/register.hpp"
#include "physics/gravity/properties.hpp"
#include "physics/gravity/register.hpp"
#include "physics/look.hpp"
#include "physics/magnetism/properties.hpp"
#include "physics/magnetism/register.hpp"
#include "physics/motor/properties.hpp"
#include "physics/motor/register.hpp"
#include "runtime/population/population_resolver.hpp"
#include "runtime/world/registry.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace trembler {
namespace {

template <class... Properties>
void registerOnly(Registry& registry) {
    (registry.property<Properties>(), ...);
}

struct Effect {
    char const* name;
    void (*registerAll)(Registry&);
    void (*registerProperties)(Registry&);
};

// The order is part of the simulation.
constexpr Effect effects[] = {
    {"electricity", registerElectricity, knowElectricity},
    {"gravity", registerGravity, registerOnly<GravityField, GravityLaw>},
    {"magnetism", registerMagnetism,
     registerOnly<MagneticStrength, MagneticPoles, Magnet, Electromagnet, MagnetismSettings>},
    {"buoyancy", registerBuoyancy, registerOnly<Liquid, BuoyancySettings>},
    {"motor", registerMotors, registerOnly<ElectricMotor, Generator>},
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
        (without.contains(effect.name) ? effect.registerProperties : effect.registerAll)(registry);
    }
    registerMaterial(registry);
    registerLook(registry);
}

} // namespace trembler
