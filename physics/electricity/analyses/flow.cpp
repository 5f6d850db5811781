#include "physics/electricity/analyses/flow.hpp"

#include "physics/electricity/analyses/two_wire.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace trembler {
namespace {

Microamperes inMicroamperes(double ampere) {
    if (!(ampere > 0)) {
        return 0; // also if it is NaN
    }
    return std::max<Microamperes>(1, std::llround(std::min(ampere, 1e9) * 1e6));
}

double inAmperes(Microamperes current) {
    return current >= unlimited ? std::numeric_limits<double>::infinity()
                                : static_cast<double>(current) / 1e6;
}

/// The circuit without the objects that cannot carry current.
Circuit without(Circuit const& circuit, std::vector<Microamperes> const& limits) {
    Circuit rest = circuit;
    rest.neighbours.clear();
    rest.offsets.assign(1, 0);
    auto const carries = [&](std::uint32_t v) { return limits[v] > 0; };
    for (std::uint32_t v = 0; v < circuit.size(); ++v) {
        if (carries(v)) {
            auto const neighbours = circuit.neighboursOf(v);
            std::copy_if(neighbours.begin(), neighbours.end(), std::back_inserter(rest.neighbours), carries);
        }
        rest.offsets.push_back(static_cast<std::uint32_t>(rest.neighbours.size()));
    }
    for (auto* const terminals : {&rest.sources, &rest.returns}) {
        std::erase_if(*terminals, [&](Circuit::Terminal const& t) { return !carries(t.vertex); });
    }
    return rest;
}

} // namespace

void FlowElectricity::update(Access& access) {
    ElectricityColumns const columns{access.read<ElectricityGraph>(), access.read<Conductor>(),
                                     access.read<ElectricalSource>(), access.read<ElectricalReturn>()};
    findChangedLimits(access.read<CurrentCapacity>(), access.read<Fuse>());
    found_.clear();
    update_.run(
        columns, access.read<GraphChanges>(), access.derived<ElectricalState>(),
        [&](Circuit const& circuit, std::vector<std::uint8_t>& on) { analyse(circuit, on); }, changed_);
    writeStateAndQuantities(access, update_, found_);
}

void FlowElectricity::findChangedLimits(Column<CurrentCapacity> const& capacities,
                                        Column<Fuse> const& fuses) {
    changed_.clear();
    std::array<std::uint64_t, 2> const versions{capacities.version(), fuses.version()};
    if (versions == seen_) {
        return;
    }
    seen_ = versions;
    std::vector<Limit> now;
    for (std::size_t r = 0; r < capacities.size(); ++r) {
        now.push_back({capacities.owners()[r], inMicroamperes(capacities.values()[r].ampere)});
    }
    for (std::size_t r = 0; r < fuses.size(); ++r) {
        now.push_back({fuses.owners()[r], inMicroamperes(fuses.values()[r].current)});
    }
    auto const order = [](Limit const& x, Limit const& y) {
        return std::pair(x.object, x.most) < std::pair(y.object, y.most);
    };
    std::sort(now.begin(), now.end(), order);
    auto const same = [](Limit const& x, Limit const& y) { return x.object == y.object; };
    now.erase(std::unique(now.begin(), now.end(), same), now.end()); // keeps the lesser of two
    std::vector<Limit> different;
    std::set_symmetric_difference(now.begin(), now.end(), limits_.begin(), limits_.end(),
                                  std::back_inserter(different), order);
    for (Limit const& limit : different) {
        changed_.push_back(limit.object);
    }
    limits_ = std::move(now);
}

Microamperes FlowElectricity::limitOf(ObjectId object) const {
    auto const at = std::lower_bound(limits_.begin(), limits_.end(), object,
                                     [](Limit const& limit, ObjectId id) { return limit.object < id; });
    return at == limits_.end() || at->object != object ? unlimited : at->most;
}

void FlowElectricity::analyse(Circuit const& circuit, std::vector<std::uint8_t>& on) {
    CircuitQuantities& found =
        found_.emplace_back(quantitiesOf(circuit, {ElectricalLevel::flow, ElectricalReason::asked, {}}));
    std::vector<Microamperes> limits;
    limits.reserve(circuit.size());
    for (ObjectId const object : circuit.objects) {
        limits.push_back(limitOf(object));
    }
    bool const barred = std::find(limits.begin(), limits.end(), 0) != limits.end();
    markTwoWire(barred ? without(circuit, limits) : circuit, on);
    if (std::find(on.begin(), on.end(), 1) == on.end()) {
        return; // no path leads from a source to a return
    }
    NetworkMembers const members(circuit);
    for (std::string_view const network : circuit.terminalNetworks()) {
        MaxFlow const flow = maxFlow(circuit, members, network, limits);
        found.circuit.flow += inAmperes(flow.total);
        for (auto const& [v, current] : flow.through) {
            found.entries[v].current += inAmperes(current);
        }
        for (std::uint32_t const v : flow.bottleneck) {
            found.circuit.bottleneck.push_back(circuit.objects[v]);
        }
    }
    auto& bottleneck = found.circuit.bottleneck;
    std::sort(bottleneck.begin(), bottleneck.end());
    bottleneck.erase(std::unique(bottleneck.begin(), bottleneck.end()), bottleneck.end());
}

} // namespace trembler
