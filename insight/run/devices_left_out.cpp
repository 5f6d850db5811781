#include "insight/run/devices_left_out.hpp"

#include "physics/magnetism/properties.hpp"
#include "physics/motor/properties.hpp"

namespace trembler::insight {

void stillDevices(World& world, std::span<ObjectId const> devices) {
    auto& strengths = world.store().column<MagneticStrength>();
    auto& motors = world.store().column<ElectricMotor>();
    for (ObjectId const id : devices) {
        if (MagneticStrength const* const before = strengths.find(id)) {
            MagneticStrength after = *before;
            after.strength = 0;
            strengths.set(id, after);
        }
        if (ElectricMotor const* const before = motors.find(id)) {
            ElectricMotor after = *before;
            after.torque = 0;
            motors.set(id, after);
        }
    }
}

void holdMagnets(World& world, std::span<ObjectId const> magnets) {
    auto& coils = world.store().column<Electromagnet>();
    for (ObjectId const id : magnets) {
        coils.remove(id);
    }
}

} // namespace trembler::insight
