// Direct current through one network: potentials and currents of a netlist.
#pragma once

#include "physics/electricity/analyses/conductance_solver.hpp"
#include "physics/electricity/core/netlist.hpp"

#include <vector>

namespace trembler {

/// The solution of a netlist. All numbers are finite.
struct NodalSolution {
    struct Object {
        double potential = 0; ///< V, of its middle; 0 if it floats
        double current = 0;  ///< A through it: half the sum of the magnitudes of the currents in its branches
        double power = 0;    ///< W of heat, a source's internal resistance included
        double supplied = 0; ///< W from its EMF
        bool floating = false;
        bool shorted = false; ///< a source: see shortedShare
    };
    std::vector<Object> objects;  ///< by node
    std::vector<double> currents; ///< A, by branch, from `from` to `to`
    double largest = 0;           ///< A, the largest current
    /// The error in Kirchhoff's first law at the worst object, as a share of the largest current. 0 if no
    /// current flows: if all are less than 1e-26 of what the EMFs could drive, which is rounding error only.
    double residual = 0;
};

/// A source is shorted if its voltage is less than this share of its EMF, or if an ideal source drives
/// current through less than `shortedOhm`. An ideal source whose poles are joined by ideal conductors, or
/// joined with those of an ideal source of another EMF, would drive an infinite current: it gets the internal
/// resistance `leastResistance`.
inline constexpr double shortedShare = 0.1;
inline constexpr double shortedOhm = 0.01;

/// Solves netlists one after the other, and reuses the parts of the last solution that stay valid.
///
/// Ideal conductors that touch are exactly one node, whatever the other resistances are. The distribution of
/// the current among them is computed afterwards, as the limit of equal resistances, one for each connection,
/// that go to zero; with only one path, by Kirchhoff's first law alone.
class NodalAnalysis {
public:
    /// The solution of `netlist`. Depends on the netlist alone, bit for bit. If the netlist equals that of
    /// the last call, nothing is computed again; if only its structure is the same, the symbolic
    /// factorisation is reused.
    NodalSolution const& solve(Netlist const& netlist);
    /// Whether the last netlist had the same structure, apart from the values of resistances above zero.
    [[nodiscard]] bool sameStructure(Netlist const& netlist) const;

    /// Of the last netlist, by node, the return node included: nodes that ideal conductors join have the same
    /// number.
    [[nodiscard]] std::span<std::uint32_t const> clusters() const { return cluster_; }
    /// By node, the return node included: whether it has no connection to a given potential.
    [[nodiscard]] bool floats(std::uint32_t node) const { return floating_[cluster_[node]] != 0; }
    /// By branch, in ohm: the values used, including those of limited ideal sources.
    [[nodiscard]] std::span<double const> resistances() const { return resistances_; }

    /// Factorisations so far, for tests and benchmarks.
    [[nodiscard]] int symbolicFactorisations() const {
        return outer_.symbolicFactorisations() + inner_.symbolicFactorisations();
    }
    [[nodiscard]] int numericFactorisations() const {
        return outer_.numericFactorisations() + inner_.numericFactorisations();
    }

private:
    void contract();
    void fixIdealSources();
    void markFloating();
    void solveBetweenClusters();
    void solveWithinClusters();
    void sumUp();
    [[nodiscard]] double drivable() const;
    [[nodiscard]] std::uint32_t clusterOf(std::uint32_t node) const { return cluster_[node]; }
    [[nodiscard]] std::uint32_t nodes() const { return netlist_.earth() + 1; }
    [[nodiscard]] bool ideal(std::size_t branch) const { return resistances_[branch] == 0; }

    Netlist netlist_;
    NodalSolution solution_;
    bool solved_ = false;
    std::vector<double> resistances_;    // by branch; those of ideal sources that had to be limited are not 0
    std::vector<std::uint8_t> limited_;  // by branch
    std::vector<std::uint32_t> cluster_; // by node; numbered in order of the first node
    std::uint32_t clusters_ = 0;
    std::vector<std::uint8_t> held_;     // by cluster: its potential is given
    std::vector<double> heldAt_;         // by cluster, V
    std::vector<std::uint8_t> floating_; // by cluster
    ConductanceSolver outer_;
    ConductanceSolver inner_;
    std::vector<ConductanceSolver::Potential> potentials_; // by cluster
};

} // namespace trembler
