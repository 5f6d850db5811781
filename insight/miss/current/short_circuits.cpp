#include "insight/miss/current/short_circuits.hpp"

#include "physics/electricity/properties/electrical.hpp"
#include "physics/electricity/properties/graph.hpp"
#include "physics/electricity/properties/quantities.hpp"
#include "physics/electricity/properties/ratings.hpp"
#include "physics/magnetism/properties.hpp"
#include "physics/motor/properties.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <string>

namespace trembler::insight {
namespace short_circuits {
namespace {

bool isLoad(World const& world, ObjectId id) {
    Resistance const* const resistance = world.find<Resistance>(id);
    return (resistance != nullptr && resistance->ohm > 0) || world.find<ElectricalDevice>(id) != nullptr ||
           world.find<RatedPower>(id) != nullptr || world.find<Electromagnet>(id) != nullptr ||
           world.find<ElectricMotor>(id) != nullptr;
}

/// Whether currents of the network pass through the object and meet no resistance there.
bool passes(World const& world, ObjectId id, std::string const& network) {
    Conductor const* const conductor = world.find<Conductor>(id);
    bool const foreign = conductor != nullptr && !conductor->network.empty() && conductor->network != network;
    return !foreign && !isLoad(world, id);
}

bool reachesReturn(World const& world, ObjectId source, std::string const& network) {
    std::set<ObjectId> seen{source};
    std::vector<ObjectId> open{source};
    while (!open.empty()) {
        ElectricityGraph const* const row = world.find<ElectricityGraph>(open.back());
        open.pop_back();
        if (row == nullptr) {
            continue;
        }
        for (ElectricityGraph::Connection const& connection : row->connections) {
            ObjectId const next = connection.to;
            if (!passes(world, next, network) || !seen.insert(next).second) {
                continue;
            }
            ElectricalReturn const* const end = world.find<ElectricalReturn>(next);
            if (end != nullptr && end->network == network) {
                return true;
            }
            open.push_back(next);
        }
    }
    return false;
}

/// Ascending; of one circuit only, if one is given.
std::vector<ObjectId> shorted(World const& world, std::optional<ObjectId> circuit) {
    std::vector<ObjectId> all;
    auto const* const quantities = world.find<ElectricalQuantities>();
    auto const* const sources = world.store().findColumn<ElectricalSource>();
    if (quantities == nullptr || sources == nullptr) {
        return all;
    }
    for (ObjectId const id : sources->owners()) {
        auto const* const entry = quantities->find(id);
        if (entry != nullptr && entry->current > 0 && (!circuit || entry->circuit == *circuit) &&
            reachesReturn(world, id, sources->find(id)->network)) {
            all.push_back(id);
        }
    }
    std::sort(all.begin(), all.end());
    return all;
}

} // namespace
} // namespace short_circuits

std::vector<ObjectId> shortCircuits(World const& world) {
    return short_circuits::shorted(world, std::nullopt);
}

ObjectId shortCircuitBeside(World const& world, ObjectId object) {
    auto const* const quantities = world.find<ElectricalQuantities>();
    auto const* const own = quantities == nullptr ? nullptr : quantities->find(object);
    auto const sources =
        own == nullptr ? std::vector<ObjectId>() : short_circuits::shorted(world, own->circuit);
    return sources.empty() ? ObjectId{} : sources.front();
}

} // namespace trembler::insight
