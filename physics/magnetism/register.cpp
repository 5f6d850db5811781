#include "physics/magnetism/register.hpp"

#include "physics/dynamics/interactions/from_magnetism.hpp"
#include "physics/magnetism/completion.hpp"
#include "physics/magnetism/frame_from_magnetism.hpp"
#include "physics/magnetism/from_electricity.hpp"
#include "physics/magnetism/magnetic_forces.hpp"
#include "physics/magnetism/magnetic_grid.hpp"
#include "physics/magnetism/magnetic_tree.hpp"
#include "physics/magnetism/magnetics_resolver.hpp"
#include "runtime/world/registry.hpp"

namespace trembler {
void registerMagnetism(Registry& registry) {
    registry.completion<SusceptibilityCompletion>();
    registry.completion<MagnetCompletion>();
    registry.component<MagneticsResolver>();
    registry.component<MagneticForces>();
    registry.component<MagneticGrid>();
    registry.component<MagneticTree>();
    registry.component<MagneticsFromElectricity>();
    registry.component<DynamicsFromMagneticForces>();
    registry.component<FrameFromMagneticForces>();
}

} // namespace trembler
