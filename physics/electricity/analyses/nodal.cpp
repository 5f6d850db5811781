#include "physics/electricity/analyses/nodal.hpp"

#include "physics/electricity/analyses/single_cable.hpp"
#include "physics/electricity/analyses/two_wire.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>

namespace trembler {
namespace {

// A rating may be so small that the quotient is no finite number.
double finiteRatio(double value, double rating) {
    return std::min(value / rating, std::numeric_limits<double>::max());
}

} // namespace

void NodalElectricity::update(Access& access) {
    ElectricityColumns const columns{access.read<ElectricityGraph>(), access.read<Conductor>(),
                                     access.read<ElectricalSource>(), access.read<ElectricalReturn>()};
    NodalColumns const nodal{access.read<Resistance>(), access.read<Emf>(), access.read<RatedPower>(),
                             access.read<Fuse>()};
    findChangedParts(nodal);
    found_.clear();
    update_.run(
        columns, access.read<GraphChanges>(), access.derived<ElectricalState>(),
        [&](Circuit const& circuit, std::vector<std::uint8_t>& on) {
            analyse(circuit, nodal, columns.returns, on);
        },
        changed_);
    writeStateAndQuantities(access, update_, found_);
}

// The objects whose stated values have changed since the last update.
void NodalElectricity::findChangedParts(NodalColumns const& columns) {
    changed_.clear();
    std::array<std::uint64_t, 4> const versions{columns.resistances.version(), columns.emfs.version(),
                                                columns.ratings.version(), columns.fuses.version()};
    if (versions == seen_) {
        return;
    }
    seen_ = versions;
    std::vector<ObjectId> owners;
    auto const gather = [&](ColumnBase const& column) {
        owners.insert(owners.end(), column.owners().begin(), column.owners().end());
    };
    gather(columns.resistances);
    gather(columns.emfs);
    gather(columns.ratings);
    gather(columns.fuses);
    std::sort(owners.begin(), owners.end());
    owners.erase(std::unique(owners.begin(), owners.end()), owners.end());
    std::vector<Part> now;
    now.reserve(owners.size());
    for (ObjectId const id : owners) {
        Part part{.object = id, .resistance = resistanceOf(columns, id), .emf = {}, .fuse = {}};
        if (Emf const* const emf = columns.emfs.find(id)) {
            part.emf = *emf;
        }
        if (RatedPower const* const rated = columns.ratings.find(id)) {
            part.ratedPower = rated->power;
        }
        if (Fuse const* const fuse = columns.fuses.find(id)) {
            part.fuse = *fuse;
        }
        now.push_back(part);
    }
    auto was = parts_.begin();
    for (Part const& part : now) {
        for (; was != parts_.end() && was->object < part.object; ++was) {
            changed_.push_back(was->object);
        }
        bool const known = was != parts_.end() && was->object == part.object;
        if (!known || *was != part) {
            changed_.push_back(part.object);
        }
        was += known ? 1 : 0;
    }
    for (; was != parts_.end(); ++was) {
        changed_.push_back(was->object);
    }
    parts_ = std::move(now);
}

void NodalElectricity::analyse(Circuit const& circuit, NodalColumns const& columns,
                               Column<ElectricalReturn> const& returns, std::vector<std::uint8_t>& on) {
    CircuitQuantities& found =
        found_.emplace_back(quantitiesOf(circuit, sufficientLevel(circuit, columns, returns)));
    switch (found.circuit.level) {
    case ElectricalLevel::singleCable:
        markSingleCable(circuit, on);
        break;
    case ElectricalLevel::nodal:
        solve(circuit, columns, found, on);
        break;
    case ElectricalLevel::twoWire:
    case ElectricalLevel::flow:
        markTwoWire(circuit, on);
        break;
    }
}

void NodalElectricity::solve(Circuit const& circuit, NodalColumns const& columns, CircuitQuantities& found,
                             std::vector<std::uint8_t>& on) {
    for (auto& entry : found.entries) {
        entry.floating = true; // until a network that contains it is solved
    }
    std::vector<std::string_view> const networks = circuit.terminalNetworks();
    std::optional<NetworkMembers> members;
    if (networks.size() > 1) {
        members.emplace(circuit);
    }
    for (std::string_view const network : networks) {
        makeNetlist(circuit, columns, network, netlist_, members ? &*members : nullptr);
        NodalSolution const& solution = kept_.solve(netlist_, network);
        found.circuit.residual = std::max(found.circuit.residual, solution.residual);
        double const least = std::max(leastCurrent, leastShare * solution.largest);
        for (std::uint32_t n = 0; n < netlist_.objects.size(); ++n) {
            NodalSolution::Object const& object = solution.objects[n];
            auto& entry = found.entries[netlist_.vertex[n]];
            if (entry.floating && !object.floating) {
                entry.potential = object.potential;
                entry.floating = false;
            }
            entry.current += object.current;
            entry.power += object.power;
            entry.supplied += object.supplied;
            RatedPower const* const rated = columns.ratings.find(entry.object);
            bool const enough = rated == nullptr || object.power >= leastPower * rated->power;
            if (object.current >= least && enough) {
                on[netlist_.vertex[n]] = 1;
            }
            if (object.shorted) {
                found.circuit.shorted.push_back(entry.object);
            }
        }
    }
    found.circuit.floating = true;
    for (auto& entry : found.entries) {
        found.circuit.floating = found.circuit.floating && entry.floating;
        if (RatedPower const* const rated = columns.ratings.find(entry.object)) {
            entry.brightness = finiteRatio(entry.power, rated->power);
        }
        if (Fuse const* const fuse = columns.fuses.find(entry.object); fuse != nullptr && !fuse->blown) {
            entry.overload = finiteRatio(entry.current, fuse->current);
        }
    }
    auto& shorted = found.circuit.shorted;
    std::sort(shorted.begin(), shorted.end());
    shorted.erase(std::unique(shorted.begin(), shorted.end()), shorted.end());
}

} // namespace trembler
