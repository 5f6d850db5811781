#include "physics/magnetism/register.hpp"

#include "physics/dynamics/from_magnetism.hpp"
#include "physics/magnetism/from_electricity.hpp"
#include "physics/magnetism/magnetic_forces.hpp"
#include "physics/magnetism/magnetic_grid.hpp"
#include "physics/magnetism/magnetic_tree.hpp"
#include "physics/magnetism/magnetics_resolver.hpp"
#include "runtime/world/registry.hpp"

namespace trembler {
namespace {

// Whatever has poles is a magnet: on if it is a permanent one, off until there is electricity otherwise.
void completeMagnet(Store& store, ObjectId id) {
    bool const coil = store.column<Electromagnet>().has(id);
    if (!coil && !store.column<MagneticPoles>().has(id)) {
        return;
    }
    if (!store.column<Magnet>().has(id)) {
        store.column<Magnet>().set(id, coil ? Magnet{false, 0} : Magnet{});
    }
}

} // namespace

void registerMagnetism(Registry& registry) {
    registry.completion(completeMagnet);
    registry.component<MagneticsResolver>();
    registry.component<MagneticForces>();
    registry.component<MagneticGrid>();
    registry.component<MagneticTree>();
    registry.component<MagneticsFromElectricity>();
    registry.component<DynamicsFromMagneticForces>();
}

} // namespace trembler
