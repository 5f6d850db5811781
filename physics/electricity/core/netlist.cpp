#include "physics/electricity/core/netlist.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace trembler {
namespace {

constexpr std::uint32_t noNode = std::numeric_limits<std::uint32_t>::max();

double withinLimits(double ohm) {
    if (!(ohm > 0)) {
        return 0; // also if it is NaN
    }
    return std::clamp(ohm, leastResistance, greatestResistance);
}

double finite(double volt) {
    return std::isfinite(volt) ? std::clamp(volt, -1e6, 1e6) : 0;
}

} // namespace

double resistanceOf(NodalColumns const& columns, ObjectId object) {
    if (Resistance const* const stated = columns.resistances.find(object)) {
        return withinLimits(stated->ohm);
    }
    if (RatedPower const* const rated = columns.ratings.find(object)) {
        return withinLimits(rated->voltage * rated->voltage / rated->power);
    }
    return 0;
}

void makeNetlist(Circuit const& circuit, NodalColumns const& columns, std::string_view network,
                 Netlist& netlist, NetworkMembers const* members) {
    netlist.vertex.clear();
    if (members != nullptr) {
        for (auto const vertices : {members->plain(), members->own(network)}) {
            netlist.vertex.insert(netlist.vertex.end(), vertices.begin(), vertices.end());
        }
    } else {
        for (std::uint32_t v = 0; v < circuit.size(); ++v) {
            if (circuit.takesPart(v, network)) {
                netlist.vertex.push_back(v);
            }
        }
    }
    std::sort(netlist.vertex.begin(), netlist.vertex.end(),
              [&](std::uint32_t a, std::uint32_t b) { return circuit.objects[a] < circuit.objects[b]; });
    std::vector<std::uint32_t> node(members == nullptr ? circuit.size() : 0, noNode);
    auto const nodeOf = [&](std::uint32_t v) {
        if (members == nullptr) {
            return node[v];
        }
        auto const at = std::lower_bound(netlist.objects.begin(), netlist.objects.end(), circuit.objects[v]);
        return static_cast<std::uint32_t>(at - netlist.objects.begin());
    };
    netlist.objects.clear();
    netlist.resistances.clear();
    for (std::uint32_t n = 0; n < netlist.vertex.size(); ++n) {
        ObjectId const object = circuit.objects[netlist.vertex[n]];
        if (members == nullptr) {
            node[netlist.vertex[n]] = n;
        }
        netlist.objects.push_back(object);
        netlist.resistances.push_back(resistanceOf(columns, object));
    }
    netlist.branches.clear();
    for (std::uint32_t n = 0; n < netlist.vertex.size(); ++n) {
        auto const join = [&](std::span<std::uint32_t const> neighbours) {
            for (std::uint32_t const w : neighbours) {
                if (std::uint32_t const m = nodeOf(w); m != noNode && n < m) {
                    netlist.branches.push_back({n, m, Netlist::Kind::connection,
                                                0.5 * netlist.resistances[n] + 0.5 * netlist.resistances[m],
                                                0});
                }
            }
        };
        if (members == nullptr) {
            join(circuit.neighboursOf(netlist.vertex[n]));
        } else {
            join(members->plainNeighboursOf(netlist.vertex[n]));
            join(members->ownNeighboursOf(netlist.vertex[n], network));
        }
    }
    // Neighbours in a row are in order of ids already, but a circuit guarantees no order.
    std::sort(netlist.branches.begin(), netlist.branches.end(),
              [](auto const& a, auto const& b) { return std::pair(a.from, a.to) < std::pair(b.from, b.to); });
    std::uint32_t const earth = netlist.earth();
    auto const terminals = [&](std::vector<Circuit::Terminal> const& all, auto&& add) {
        std::vector<std::uint32_t> nodes;
        for (Circuit::Terminal const& terminal : terminalsOf(all, network)) {
            nodes.push_back(nodeOf(terminal.vertex));
        }
        std::sort(nodes.begin(), nodes.end());
        std::for_each(nodes.begin(), nodes.end(), add);
    };
    terminals(circuit.sources, [&](std::uint32_t n) {
        Emf const* const stated = columns.emfs.find(netlist.objects[n]);
        Emf const emf = stated == nullptr ? Emf{.voltage = unstatedEmf} : *stated;
        netlist.branches.push_back({earth, n, Netlist::Kind::source,
                                    withinLimits(emf.internalResistance) + 0.5 * netlist.resistances[n],
                                    finite(emf.voltage + emf.induced)});
    });
    terminals(circuit.returns, [&](std::uint32_t n) {
        netlist.branches.push_back({n, earth, Netlist::Kind::returning, 0.5 * netlist.resistances[n], 0});
    });
}

} // namespace trembler
