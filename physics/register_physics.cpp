#include "physics/register_physics.hpp"

#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/buoyancy/properties/settings.hpp"
#include "physics/buoyancy/register.hpp"
#include "physics/dynamics/register.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/electricity/properties/ratings.hpp"
#include "physics/electricity/register.hpp"
#include "physics/electricity/rules/wire.hpp"
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

// Connections of a level that has no electricity: they may be stated, and nothing flows.
void layNothing(Store& /*store*/, ObjectId /*a*/, ObjectId /*b*/) {}

void knowElectricity(Registry& registry) {
    registerOnly<Conductor, ElectricalSource, ElectricalReturn, ElectricalDevice, Resistance, Emf, RatedPower,
                 Fuse, CurrentCapacity>(registry);
    registry.connector(wireConnector(layNothing));
}

struct Effect {
    char const* name;
    void (*registerAll)(Registry&); ///< nullptr: this program was built without it
    void (*registerProperties)(Registry&);
};

// The order is part of the simulation.
constexpr Effect effects[] = {
#ifdef TREMBLER_WITHOUT_ELECTRICITY
    {"electricity", nullptr, knowElectricity},
#else
    {"electricity", registerElectricity, knowElectricity},
#endif
#ifdef TREMBLER_WITHOUT_GRAVITY
    {"gravity", nullptr, registerOnly<GravityField, GravityLaw>},
#else
    {"gravity", registerGravity, registerOnly<GravityField, GravityLaw>},
#endif
#ifdef TREMBLER_WITHOUT_MAGNETISM
    {"magnetism", nullptr,
     registerOnly<MagneticStrength, MagneticPoles, Magnet, Electromagnet, MagnetismSettings>},
#else
    {"magnetism", registerMagnetism,
     registerOnly<MagneticStrength, MagneticPoles, Magnet, Electromagnet, MagnetismSettings>},
#endif
#ifdef TREMBLER_WITHOUT_BUOYANCY
    {"buoyancy", nullptr, registerOnly<Liquid, BuoyancySettings>},
#else
    {"buoyancy", registerBuoyancy, registerOnly<Liquid, BuoyancySettings>},
#endif
#ifdef TREMBLER_WITHOUT_MOTOR
    {"motor", nullptr, registerOnly<ElectricMotor, Generator>},
#else
    {"motor", registerMotors, registerOnly<ElectricMotor, Generator>},
#endif
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

std::set<std::string> const& effectsLeftOut() {
    static std::set<std::string> const names = [] {
        std::set<std::string> found;
        for (Effect const& effect : effects) {
            if (effect.registerAll == nullptr) {
                found.insert(effect.name);
            }
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
        bool const there = effect.registerAll != nullptr && !without.contains(effect.name);
        (there ? effect.registerAll : effect.registerProperties)(registry);
    }
    registerMaterial(registry);
    registerLook(registry);
}

} // namespace trembler
