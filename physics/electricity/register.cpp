#include "physics/electricity/register.hpp"

#include "physics/electricity/analyses/flow.hpp"
#include "physics/electricity/analyses/nodal.hpp"
#include "physics/electricity/analyses/single_cable.hpp"
#include "physics/electricity/analyses/two_wire.hpp"
#include "physics/electricity/core/electricity_resolver.hpp"
#include "physics/electricity/interactions/from_dynamics.hpp"
#include "physics/electricity/interactions/from_fuses.hpp"
#include "physics/electricity/interactions/from_player.hpp"
#include "physics/electricity/rules/completion.hpp"
#include "physics/electricity/rules/initial_connections.hpp"
#include "physics/electricity/rules/wire.hpp"
#include "runtime/world/registry.hpp"

#include <fmt/format.h>

namespace trembler {
namespace {

template <class P>
P const* find(Store const& store, ObjectId id) {
    auto const* const column = store.findColumn<P>();
    return column == nullptr ? nullptr : column->find(id);
}

// As stated, or from the material: rules check objects before they are completed.
std::optional<Conductor> conductorOf(Store const& store, ObjectId id) {
    if (Conductor const* const stated = find<Conductor>(store, id)) {
        return *stated;
    }
    return conductsByMaterial(find<MadeOf>(store, id), find<Without>(store, id)) ? std::optional(Conductor{})
                                                                                 : std::nullopt;
}

// An object that is joined to a network must be a vertex of the graph, and take part in that network.
template <class Terminal>
std::optional<std::string> checkTerminal(Store const& store, ObjectId id) {
    std::optional<Conductor> const conductor = conductorOf(store, id);
    if (!conductor) {
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

// An object with a property about currents must be a conductor.
template <class P>
std::optional<std::string> checkConducts(Store const& store, ObjectId id) {
    if (!conductorOf(store, id)) {
        return fmt::format(
            "'{}' is no conductor, so no current can reach it; expected the property '{}' beside '{}'",
            store.nameOf(id), Conductor::text.key, P::text.key);
    }
    return std::nullopt;
}

// Refuses a resistance that is neither 0 nor within the solver's range.
std::optional<std::string> checkOhm(Store const& store, ObjectId id, double ohm, std::string_view what) {
    if (ohm != 0 && (ohm < leastResistance || ohm > greatestResistance)) {
        return fmt::format("the {} of '{}' is {} ohm; expected 0, or {} to {} ohm", what, store.nameOf(id),
                           ohm, leastResistance, greatestResistance);
    }
    return std::nullopt;
}

std::optional<std::string> checkResistance(Store const& store, ObjectId id) {
    if (auto wrong = checkConducts<Resistance>(store, id)) {
        return wrong;
    }
    return checkOhm(store, id, (*store.findColumn<Resistance>())[id].ohm, "resistance");
}

std::optional<std::string> checkEmf(Store const& store, ObjectId id) {
    auto const* const sources = store.findColumn<ElectricalSource>();
    if (sources == nullptr || !sources->has(id)) {
        return fmt::format(
            "'{}' is no source, so its EMF drives nothing; expected the property '{}' beside '{}'",
            store.nameOf(id), ElectricalSource::text.key, Emf::text.key);
    }
    return checkOhm(store, id, (*store.findColumn<Emf>())[id].internalResistance, "internal resistance");
}

std::optional<std::string> checkRating(Store const& store, ObjectId id) {
    if (auto wrong = checkConducts<RatedPower>(store, id)) {
        return wrong;
    }
    auto const* const resistances = store.findColumn<Resistance>();
    if (resistances != nullptr && resistances->has(id)) {
        return std::nullopt; // the stated value is checked, not one that follows from it
    }
    RatedPower const& rated = (*store.findColumn<RatedPower>())[id];
    return checkOhm(store, id, rated.voltage * rated.voltage / rated.power,
                    "resistance that follows from the rating");
}

} // namespace

void registerElectricity(Registry& registry) {
    registry.component<ElectricityResolver>();
    registry.component<SingleCableElectricity>();
    registry.component<TwoWireElectricity>();
    registry.component<NodalElectricity>();
    registry.component<FlowElectricity>();
    registry.component<ElectricityFromDynamics>();
    registry.component<ElectricityFromPlayer>();
    registry.component<ElectricityFromFuses>();
    registry.property<ElectricalDevice>();
    registry.completion<ConductorCompletion>();
    registry.completion<VertexCompletion>();
    registry.connector({"wire", "electricity", "a wire between two conductors, which the player can cut",
                        refuseWire, layWire});
    registry.rule({&propertyInfo<ElectricalSource>(), checkTerminal<ElectricalSource>});
    registry.rule({&propertyInfo<ElectricalReturn>(), checkTerminal<ElectricalReturn>});
    registry.rule({&propertyInfo<Resistance>(), checkResistance});
    registry.rule({&propertyInfo<Emf>(), checkEmf});
    registry.rule({&propertyInfo<RatedPower>(), checkRating});
    registry.rule({&propertyInfo<Fuse>(), checkConducts<Fuse>});
    registry.rule({&propertyInfo<CurrentCapacity>(), checkConducts<CurrentCapacity>});
}

} // namespace trembler
