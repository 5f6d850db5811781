#include "physics/motor/register.hpp"

#include "physics/motor/dynamics_from_motors.hpp"
#include "physics/motor/electricity_from_rotation.hpp"
#include "runtime/placement.hpp"
#include "runtime/world/registry.hpp"

#include <fmt/format.h>

namespace trembler {
namespace {

// The object must be a conductor and a movable body.
std::optional<std::string> checkTurns(Store const& store, ObjectId id, PropertyText const& text) {
    if (!store.has<Conductor>(id)) {
        return fmt::format("'{}' is no conductor, so no current can flow through it; expected the property "
                           "'{}' beside '{}'",
                           store.nameOf(id), Conductor::text.key, text.key);
    }
    if (!store.has<Shape>(id) || !store.has<Position>(id) || store.has<Fixed>(id)) {
        return fmt::format("'{}' cannot turn; expected an object with a shape and a place that is not fixed",
                           store.nameOf(id));
    }
    return std::nullopt;
}

std::optional<std::string> checkMotor(Store const& store, ObjectId id) {
    ObjectId const against = store.findColumn<ElectricMotor>()->find(id)->against;
    if (against == id) {
        return fmt::format("'{}' turns against itself; expected another object, or none for the world",
                           store.nameOf(id));
    }
    return checkTurns(store, id, ElectricMotor::text);
}

std::optional<std::string> checkGenerator(Store const& store, ObjectId id) {
    ObjectId const source = store.findColumn<Generator>()->find(id)->source;
    if (source == id || !store.has<ElectricalSource>(source)) {
        return fmt::format(
            "the source of '{}' is not an electrical source; expected another object with the property '{}'",
            store.nameOf(id), ElectricalSource::text.key);
    }
    return checkTurns(store, id, Generator::text);
}

} // namespace

void registerMotors(Registry& registry) {
    registry.component<DynamicsFromElectricity>();
    registry.component<DynamicsFromGenerators>();
    registry.component<ElectricityFromRotation>();
    registry.rule({&propertyInfo<ElectricMotor>(), checkMotor});
    registry.rule({&propertyInfo<Generator>(), checkGenerator});
}

} // namespace trembler
