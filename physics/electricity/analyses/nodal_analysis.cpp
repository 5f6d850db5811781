#include "physics/electricity/analyses/nodal_analysis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace trembler {
namespace {

constexpr std::uint32_t noCluster = std::numeric_limits<std::uint32_t>::max();
// A share of the current that the EMFs could drive. Smaller currents are rounding errors of the potentials,
// which are exact to 1e-32. A current through resistances is at least 1e-16 of it, divided by their number.
constexpr double roundingShare = 1e-26;

/// Disjoint sets whose representative is their least element.
class Sets {
public:
    explicit Sets(std::uint32_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }
    std::uint32_t find(std::uint32_t v) {
        while (parent_[v] != v) {
            parent_[v] = parent_[parent_[v]];
            v = parent_[v];
        }
        return v;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        std::uint32_t const first = find(a);
        std::uint32_t const second = find(b);
        parent_[std::max(first, second)] = std::min(first, second);
    }

private:
    std::vector<std::uint32_t> parent_;
};

} // namespace

bool NodalAnalysis::sameStructure(Netlist const& netlist) const {
    return solved_ && netlist.objects == netlist_.objects &&
           std::equal(netlist.branches.begin(), netlist.branches.end(), netlist_.branches.begin(),
                      netlist_.branches.end(), [](Netlist::Branch const& a, Netlist::Branch const& b) {
                          return a.from == b.from && a.to == b.to && a.kind == b.kind &&
                                 (a.resistance == 0) == (b.resistance == 0);
                      });
}

NodalSolution const& NodalAnalysis::solve(Netlist const& netlist) {
    if (solved_ && netlist.objects == netlist_.objects && netlist.resistances == netlist_.resistances &&
        netlist.branches == netlist_.branches) {
        return solution_;
    }
    netlist_ = netlist;
    solved_ = true;
    contract();
    fixIdealSources();
    markFloating();
    solution_.currents.assign(netlist_.branches.size(), 0);
    solveBetweenClusters();
    solveWithinClusters();
    sumUp();
    return solution_;
}

// Nodes that are joined by ideal conductors become one.
void NodalAnalysis::contract() {
    std::size_t const count = netlist_.branches.size();
    resistances_.resize(count);
    limited_.assign(count, 0);
    Sets sets(nodes());
    for (std::size_t b = 0; b < count; ++b) {
        Netlist::Branch const& branch = netlist_.branches[b];
        resistances_[b] = branch.resistance;
        if (branch.resistance == 0 && branch.kind != Netlist::Kind::source) {
            sets.join(branch.from, branch.to);
        }
    }
    cluster_.assign(nodes(), noCluster);
    clusters_ = 0;
    for (std::uint32_t v = 0; v < nodes(); ++v) {
        std::uint32_t const first = sets.find(v);
        cluster_[v] = first == v ? clusters_++ : cluster_[first];
    }
}

// An ideal source holds its cluster at its EMF, unless the cluster is already held at another potential.
void NodalAnalysis::fixIdealSources() {
    held_.assign(clusters_, 0);
    heldAt_.assign(clusters_, 0);
    std::vector<std::uint8_t> contradiction(clusters_, 0);
    held_[clusterOf(netlist_.earth())] = 1;
    for (std::size_t b = 0; b < netlist_.branches.size(); ++b) {
        Netlist::Branch const& branch = netlist_.branches[b];
        if (branch.kind != Netlist::Kind::source || !ideal(b)) {
            continue;
        }
        std::uint32_t const c = clusterOf(branch.to);
        if (held_[c] != 0 && heldAt_[c] != branch.emf) {
            contradiction[c] = 1;
        }
        held_[c] = 1;
        heldAt_[c] = branch.emf;
    }
    for (std::size_t b = 0; b < netlist_.branches.size(); ++b) {
        Netlist::Branch const& branch = netlist_.branches[b];
        if (branch.kind == Netlist::Kind::source && ideal(b) && contradiction[clusterOf(branch.to)] != 0) {
            resistances_[b] = leastResistance;
            limited_[b] = 1;
        }
    }
    for (std::uint32_t c = 0; c < clusters_; ++c) {
        if (contradiction[c] != 0) {
            held_[c] = c == clusterOf(netlist_.earth()) ? 1 : 0;
            heldAt_[c] = 0;
        }
    }
}

// Nodes that no resistance connects to a given potential have no determined potential; it is set to 0 V, and
// no current flows.
void NodalAnalysis::markFloating() {
    Sets sets(clusters_);
    for (std::size_t b = 0; b < netlist_.branches.size(); ++b) {
        if (!ideal(b)) {
            sets.join(clusterOf(netlist_.branches[b].from), clusterOf(netlist_.branches[b].to));
        }
    }
    std::vector<std::uint8_t> grounded(clusters_, 0);
    for (std::uint32_t c = 0; c < clusters_; ++c) {
        if (held_[c] != 0) {
            grounded[sets.find(c)] = 1;
        }
    }
    floating_.resize(clusters_);
    for (std::uint32_t c = 0; c < clusters_; ++c) {
        floating_[c] = grounded[sets.find(c)] != 0 ? 0 : 1;
    }
}

void NodalAnalysis::solveBetweenClusters() {
    std::vector<ConductanceSolver::Edge> edges;
    std::vector<double> conductances;
    std::vector<double> emfs;
    std::vector<std::size_t> branches;
    for (std::size_t b = 0; b < netlist_.branches.size(); ++b) {
        Netlist::Branch const& branch = netlist_.branches[b];
        std::uint32_t const from = clusterOf(branch.from);
        std::uint32_t const to = clusterOf(branch.to);
        if (ideal(b)) {
            continue;
        }
        if (from == to) { // ideal conductors join a source's poles, or a resistor's two connections
            solution_.currents[b] = branch.emf / resistances_[b];
            continue;
        }
        edges.push_back({from, to});
        conductances.push_back(1 / resistances_[b]);
        emfs.push_back(branch.emf);
        branches.push_back(b);
    }
    std::vector<std::uint8_t> fixed(clusters_);
    potentials_.assign(clusters_, {});
    for (std::uint32_t c = 0; c < clusters_; ++c) {
        fixed[c] = held_[c] != 0 || floating_[c] != 0 ? 1 : 0;
        potentials_[c].high = heldAt_[c];
    }
    outer_.setStructure(edges, fixed);
    outer_.setConductances(conductances);
    std::vector<double> currents;
    outer_.solve(emfs, {}, potentials_, currents);
    for (std::size_t e = 0; e < branches.size(); ++e) {
        solution_.currents[branches[e]] = currents[e];
    }
}

// Ideal branches are edges of conductance 1. Each ideal source takes its current from an extra node of its
// cluster, the pump; the currents that leave through resistances are already known.
void NodalAnalysis::solveWithinClusters() {
    std::vector<std::uint32_t> pump(clusters_, noCluster);
    std::uint32_t count = nodes();
    std::vector<ConductanceSolver::Edge> edges;
    std::vector<std::size_t> branches;
    std::vector<double> injected(count, 0);
    for (std::size_t b = 0; b < netlist_.branches.size(); ++b) {
        Netlist::Branch const& branch = netlist_.branches[b];
        if (!ideal(b)) {
            injected[branch.from] -= solution_.currents[b];
            injected[branch.to] += solution_.currents[b];
        } else if (branch.kind == Netlist::Kind::source) {
            std::uint32_t& from = pump[clusterOf(branch.to)];
            from = from == noCluster ? count++ : from;
            edges.push_back({from, branch.to});
            branches.push_back(b);
        } else {
            edges.push_back({branch.from, branch.to});
            branches.push_back(b);
        }
    }
    if (edges.empty()) {
        return;
    }
    std::vector<std::uint8_t> fixed(count, 0);
    std::vector<std::uint8_t> grounded(clusters_, 0);
    fixed[netlist_.earth()] = 1;
    grounded[clusterOf(netlist_.earth())] = 1;
    for (std::uint32_t c = 0; c < clusters_; ++c) {
        if (pump[c] != noCluster) {
            fixed[pump[c]] = 1;
            grounded[c] = 1;
        }
    }
    for (std::uint32_t v = 0; v < nodes(); ++v) {
        if (std::uint32_t const c = clusterOf(v); grounded[c] == 0) {
            fixed[v] = 1; // the first node of its cluster
            grounded[c] = 1;
        }
    }
    injected.resize(count, 0);
    inner_.setStructure(edges, fixed);
    inner_.setConductances(std::vector<double>(edges.size(), 1.0));
    std::vector<ConductanceSolver::Potential> potentials(count);
    std::vector<double> currents;
    inner_.solve({}, injected, potentials, currents);
    for (std::size_t e = 0; e < branches.size(); ++e) {
        solution_.currents[branches[e]] = currents[e];
    }
}

// A current that the greatest EMF could drive through the greatest conductance alone.
double NodalAnalysis::drivable() const {
    double emf = 0;
    double conductance = 0;
    for (std::size_t b = 0; b < netlist_.branches.size(); ++b) {
        emf = std::max(emf, std::abs(netlist_.branches[b].emf));
        if (!ideal(b)) {
            conductance = std::max(conductance, 1 / resistances_[b]);
        }
    }
    return emf * conductance;
}

void NodalAnalysis::sumUp() {
    auto& objects = solution_.objects;
    objects.assign(netlist_.objects.size(), {});
    std::vector<double> balance(nodes(), 0);
    solution_.largest = 0;
    for (std::uint32_t v = 0; v < objects.size(); ++v) {
        objects[v].potential = potentials_[clusterOf(v)].high;
        objects[v].floating = floating_[clusterOf(v)] != 0;
    }
    for (std::size_t b = 0; b < netlist_.branches.size(); ++b) {
        Netlist::Branch const& branch = netlist_.branches[b];
        double const i = solution_.currents[b];
        double const size = std::abs(i);
        solution_.largest = std::max(solution_.largest, size);
        balance[branch.from] -= i;
        balance[branch.to] += i;
        for (std::uint32_t const v : {branch.from, branch.to}) {
            if (v < objects.size()) {
                objects[v].current += 0.5 * size;
                if (branch.kind == Netlist::Kind::connection) {
                    objects[v].power += i * i * 0.5 * netlist_.resistances[v];
                } else {
                    objects[v].power += i * i * resistances_[b];
                }
            }
        }
    }
    for (std::size_t b = 0; b < netlist_.branches.size(); ++b) {
        Netlist::Branch const& branch = netlist_.branches[b];
        if (branch.kind == Netlist::Kind::source) {
            auto& object = objects[branch.to];
            double const size = std::abs(solution_.currents[b]);
            double const emf = std::abs(branch.emf);
            object.supplied = branch.emf * solution_.currents[b];
            object.shorted =
                limited_[b] != 0 ||
                (size > 0 && emf > 0 &&
                 (std::abs(object.potential) < shortedShare * emf || (ideal(b) && emf < shortedOhm * size)));
        }
    }
    double worst = 0;
    for (std::uint32_t v = 0; v < objects.size(); ++v) {
        worst = std::max(worst, std::abs(balance[v]));
    }
    solution_.residual = solution_.largest > roundingShare * drivable() ? worst / solution_.largest : 0;
}

} // namespace trembler
