#include "insight/miss/idle_devices.hpp"

#include "insight/miss/current/short_circuits.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/magnetism/properties.hpp"
#include "physics/motor/properties.hpp"
#include "runtime/placement.hpp"

#include <algorithm>
#include <set>

namespace trembler::insight {
namespace idle_devices {
namespace {

bool isMovable(World const& world, ObjectId id) {
    return id.valid() && world.find<Shape>(id) != nullptr && world.find<Fixed>(id) == nullptr;
}

bool turnsOneOf(ElectricMotor const& motor, ObjectId rotor, std::span<ObjectId const> bodies) {
    return std::any_of(bodies.begin(), bodies.end(),
                       [&](ObjectId body) { return body == rotor || body == motor.against; });
}

bool attractsOneOf(World const& world, ObjectId coil, std::span<ObjectId const> bodies) {
    Position const* const at = world.find<Position>(coil);
    return at != nullptr && std::any_of(bodies.begin(), bodies.end(), [&](ObjectId body) {
               MagneticStrength const* const strength = world.find<MagneticStrength>(body);
               Position const* const from = world.find<Position>(body);
               return body != coil && strength != nullptr && from != nullptr &&
                      strength->susceptibility > 0 && strength->strength <= 0 &&
                      length(from->value - at->value) <= coilReach;
           });
}

} // namespace
} // namespace idle_devices

bool isIdle(World const& world, ObjectId device) {
    auto const* const state = world.find<ElectricalState>();
    bool const isDevice =
        world.find<Electromagnet>(device) != nullptr || world.find<ElectricMotor>(device) != nullptr;
    return isDevice && (state == nullptr || !state->isOn(device));
}

std::vector<ObjectId> tiedBodies(World const& world, load::Neighbours const& neighbours, ObjectId body) {
    if (!idle_devices::isMovable(world, body)) {
        return {};
    }
    std::set<ObjectId> all{body};
    std::vector<ObjectId> open{body};
    while (!open.empty()) {
        ObjectId const one = open.back();
        open.pop_back();
        for (load::Neighbour const& tie : neighbours.tiedTo(one)) {
            if (idle_devices::isMovable(world, tie.other) && all.insert(tie.other).second) {
                open.push_back(tie.other);
            }
        }
    }
    return {all.begin(), all.end()};
}

std::vector<ObjectId> idleDevicesOf(World const& world, std::span<ObjectId const> bodies) {
    std::set<ObjectId> devices;
    if (auto const* const motors = world.store().findColumn<ElectricMotor>()) {
        for (ObjectId const id : motors->owners()) {
            if (isIdle(world, id) && idle_devices::turnsOneOf(*motors->find(id), id, bodies)) {
                devices.insert(id);
            }
        }
    }
    if (auto const* const coils = world.store().findColumn<Electromagnet>()) {
        for (ObjectId const id : coils->owners()) {
            if (isIdle(world, id) && idle_devices::attractsOneOf(world, id, bodies)) {
                devices.insert(id);
            }
        }
    }
    return {devices.begin(), devices.end()};
}

Miss missOfIdle(World const& world, ObjectId device, CircuitSight& circuits) {
    CircuitCut const& cut = circuits.cutAt(world, device);
    Miss miss;
    miss.objects = {device};
    miss.lack = cut.hopeless ? Lack::source : cut.gaps.empty() ? Lack::change : Lack::gap;
    miss.by = cut.gaps.empty() ? 1 : cut.width;
    miss.gaps = cut.gaps;
    if (miss.lack == Lack::change) {
        if (ObjectId const source = shortCircuitBeside(world, device); source.valid()) {
            miss.lack = Lack::shorted;
            miss.objects.push_back(source);
        }
    }
    return miss;
}

} // namespace trembler::insight
