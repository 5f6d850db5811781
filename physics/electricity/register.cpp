#include "physics/electricity/register.hpp"

#include "physics/electricity/electricity_resolver.hpp"
#include "physics/electricity/from_dynamics.hpp"
#include "physics/electricity/from_player.hpp"
#include "physics/electricity/initial_connections.hpp"
#include "physics/electricity/single_cable.hpp"
#include "physics/electricity/two_wire.hpp"
#include "runtime/world/registry.hpp"

#include <fmt/format.h>

namespace trembler {
namespace {

// What is joined to a network must be a vertex of the graph, and take part in that network.
template <class Terminal>
std::optional<std::string> checkTerminal(Store const& store, ObjectId id) {
    auto const* const conductors = store.findColumn<Conductor>();
    Conductor const* const conductor = conductors == nullptr ? nullptr : conductors->find(id);
    if (conductor == nullptr) {
        return fmt::format(
            "'{}' is no conductor, so no current can reach it; expected the property '{}' beside "
            "'{}'",
            store.nameOf(id), Conductor::text.key, Terminal::text.key);
    }
    std::string const& network = (*store.findColumn<Terminal>())[id].network;
    if (!conductor->network.empty() && conductor->network != network) {
        return fmt::format(
            "'{}' is made for the network '{}' only, but belongs to '{}'; expected the same network, "
            "or a conductor without one",
            store.nameOf(id), conductor->network, network);
    }
    return std::nullopt;
}

// Every conductor is a vertex from its birth on, even where it is the one that calls for the resolver.
void makeVertex(Store& store, ObjectId id) {
    if (store.column<Conductor>().has(id)) {
        store.column<ElectricityGraph>().addDefault(id);
    }
}

} // namespace

void registerElectricity(Registry& registry) {
    registry.component<ElectricityResolver>();
    registry.component<SingleCableElectricity>();
    registry.component<TwoWireElectricity>();
    registry.component<ElectricityFromDynamics>();
    registry.component<ElectricityFromPlayer>();
    registry.property<ElectricalDevice>();
    registry.completion(makeVertex);
    registry.connector(connectInitially);
    registry.rule({&propertyInfo<ElectricalSource>(), checkTerminal<ElectricalSource>});
    registry.rule({&propertyInfo<ElectricalReturn>(), checkTerminal<ElectricalReturn>});
}

} // namespace trembler
