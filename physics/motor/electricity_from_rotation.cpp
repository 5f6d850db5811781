#include "physics/motor/electricity_from_rotation.hpp"

#include "runtime/property/for_each.hpp"

#include <array>
#include <cmath>

namespace trembler {

void ElectricityFromRotation::apply(Access& access) {
    auto const& graph = access.read<ElectricityGraph>();
    auto const& speeds = access.read<AngularVelocity>();
    forEach(
        [&](ObjectId id, Generator const& generator) {
            if (!graph.has(id) || !graph.has(generator.source)) {
                return;
            }
            AngularVelocity const* const turning = speeds.find(id);
            double const speed = turning == nullptr ? 0 : std::abs(turning->value);
            bool const connected = connectionBetween(graph, id, generator.source).of(access.caller()) > 0;
            ConnectionKey const key{id, generator.source};
            if (!connected && speed >= generator.speed) {
                access.call(AddConnection{key}, access.event("turns fast enough", std::array{id},
                                                             access.read<MotionCauses>().of(id)));
            } else if (connected && speed < lettingGo * generator.speed) {
                access.call(RemoveConnection{key}, access.event("turns too slowly", std::array{id},
                                                                access.read<MotionCauses>().of(id)));
            }
        },
        access.read<Generator>());
}

} // namespace trembler
