#include "physics/motor/dynamics_from_motors.hpp"

#include "physics/motor/rotor.hpp"
#include "physics/motor/torque.hpp"
#include "runtime/property/for_each.hpp"

namespace trembler {
namespace {

double speedOf(Column<AngularVelocity> const& speeds, ObjectId object) {
    AngularVelocity const* const speed = speeds.find(object);
    return speed == nullptr ? 0 : speed->value;
}

} // namespace

void DynamicsFromElectricity::apply(Access& access) {
    auto const& state = access.read<ElectricalState>();
    auto const& speeds = access.read<AngularVelocity>();
    auto const inertia = [&](ObjectId object) {
        return inertiaOf(object, access.read<Mass>(), access.read<Shape>(), access.read<Fixed>());
    };
    forEach(
        [&](ObjectId id, ElectricMotor const& motor) {
            if (!state.isOn(id)) {
                return;
            }
            double const reduced = reducedInertia(inertia(id), inertia(motor.against));
            double const speed = speedOf(speeds, id) - speedOf(speeds, motor.against);
            double const torque = motorTorque(motor, speed, reduced, access.duration());
            access.call(AddTorque{id, torque}, state.eventOf(id));
            if (double const rate = motorRate(motor, reduced, access.duration()); rate > 0) {
                access.call(StateRate{.object = id, .rate = rate, .foreseen = false, .swings = false});
            }
            if (motor.against.valid()) {
                access.call(AddTorque{motor.against, -torque}, state.eventOf(id));
            }
        },
        access.read<ElectricMotor>());
}

void DynamicsFromGenerators::apply(Access& access) {
    auto const& state = access.read<ElectricalState>();
    auto const& speeds = access.read<AngularVelocity>();
    forEach(
        [&](ObjectId id, Generator const& generator) {
            if (state.isOn(id)) {
                double const inertia =
                    inertiaOf(id, access.read<Mass>(), access.read<Shape>(), access.read<Fixed>());
                access.call(
                    AddTorque{id, brakingTorque(generator, speedOf(speeds, id), inertia, access.duration())},
                    state.eventOf(id));
            }
        },
        access.read<Generator>());
}

} // namespace trembler
