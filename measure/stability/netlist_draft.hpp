// Builds netlists branch by branch, without objects, and checks their solution.
#pragma once

#include "physics/electricity/analyses/nodal_analysis.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace trembler::stability {

/// A netlist of nodes 0, 1, 2 ..., each an object of its own without resistance.
struct Draft {
    Netlist netlist;

    explicit Draft(std::uint32_t nodes) {
        for (std::uint32_t v = 0; v < nodes; ++v) {
            netlist.objects.push_back({v, 0});
            netlist.vertex.push_back(v);
        }
        netlist.resistances.assign(nodes, 0);
    }
    void join(std::uint32_t a, std::uint32_t b, double ohm) {
        netlist.branches.push_back({a, b, Netlist::Kind::connection, ohm, 0});
    }
    void source(std::uint32_t node, double volt, double ohm) {
        netlist.branches.push_back({netlist.earth(), node, Netlist::Kind::source, ohm, volt});
    }
    void earth(std::uint32_t node, double ohm) {
        netlist.branches.push_back({node, netlist.earth(), Netlist::Kind::returning, ohm, 0});
    }
};

/// The violation of Kirchhoff's first law at a node, relative to the current through that node: the largest
/// of all nodes. Stricter than relative to the largest current anywhere. Nodes with only rounding errors are
/// skipped. Computed from the currents alone, in long double.
[[nodiscard]] inline double localResidual(Netlist const& netlist, NodalSolution const& solution) {
    std::vector<long double> balance(netlist.objects.size() + 1, 0);
    std::vector<long double> passing(netlist.objects.size() + 1, 0);
    for (std::size_t b = 0; b < netlist.branches.size(); ++b) {
        long double const i = solution.currents[b];
        balance[netlist.branches[b].from] -= i;
        balance[netlist.branches[b].to] += i;
        passing[netlist.branches[b].from] += std::abs(i);
        passing[netlist.branches[b].to] += std::abs(i);
    }
    long double worst = 0;
    for (std::size_t v = 0; v < netlist.objects.size(); ++v) {
        if (passing[v] > 1e-13L * solution.largest) {
            worst = std::max(worst, std::abs(balance[v]) / passing[v]);
        }
    }
    return static_cast<double>(worst);
}

} // namespace trembler::stability
