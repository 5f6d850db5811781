// The linear algebra of nodal analysis: nodes connected by conductances, some with known potentials.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace trembler {

/// Finds the potentials at which as much current flows into every node as out of it (Kirchhoff's first law).
///
/// The matrix of the unknown potentials is symmetric and positive definite; it is factorised as LDLᵀ without
/// square roots (Eigen's SimplicialLDLT, with approximate minimum degree ordering). The symbolic
/// factorisation is kept while the structure is the same, the numeric one while the conductances are the
/// same, too.
///
/// The condition of the matrix, up to 1e16 here, limits the precision of one solution. So potentials are sums
/// of two numbers, the currents are computed edge by edge from exact differences, and their error in
/// Kirchhoff's law is corrected repeatedly until it no longer decreases (iterative refinement, Wilkinson
/// 1963). If the factorisation is too inexact for that, it is the preconditioner of conjugate gradients.
///
/// The result depends on the arguments alone, bit for bit. Not thread-safe; one solver per thread.
class ConductanceSolver {
public:
    struct Edge {
        std::uint32_t from = 0;
        std::uint32_t to = 0;
        friend bool operator==(Edge const&, Edge const&) = default;
    };
    /// A potential in V: high + low, where high is the nearest double and low the rest.
    struct Potential {
        double high = 0;
        double low = 0;
    };

    ConductanceSolver();
    ~ConductanceSolver();
    ConductanceSolver(ConductanceSolver&&) noexcept;
    ConductanceSolver& operator=(ConductanceSolver&&) noexcept;

    /// Sets which nodes are connected; edges may repeat, but must not connect a node to itself. `fixed` is 1
    /// for nodes whose potential is given; every other node must be connected to one of them, directly or
    /// indirectly.
    void setStructure(std::span<Edge const> edges, std::span<std::uint8_t const> fixed);
    /// Siemens, by edge; all above zero and finite.
    void setConductances(std::span<double const> conductances);
    /// Solves. `emfs` (V) raise the potential along an edge from `from` to `to`: i = g (V_from - V_to + emf).
    /// `injected` (A) flows into each node from outside. `potentials` must contain those of the fixed nodes.
    /// Afterwards `currents` are along the edges, in A.
    void solve(std::span<double const> emfs, std::span<double const> injected,
               std::vector<Potential>& potentials, std::vector<double>& currents);

    /// The numbers of factorisations, for tests and benchmarks.
    [[nodiscard]] int symbolicFactorisations() const { return symbolic_; }
    [[nodiscard]] int numericFactorisations() const { return numeric_; }

private:
    struct Factor;
    /// The error in Kirchhoff's law at the worst node: in A, and as a share of the currents that pass it.
    struct Misses {
        double current = 0;
        double share = 0;
    };
    void factorise(double shift);
    void flow(std::span<double const> emfs, std::span<Potential const> potentials,
              std::vector<double>& currents) const;
    Misses misses(std::span<double const> injected, std::span<double const> currents);
    void correct();
    void conjugateGradients();
    void multiply(std::vector<double> const& x, std::vector<double>& y) const;

    std::vector<Edge> edges_;
    std::vector<std::uint8_t> fixed_;
    std::vector<std::uint32_t> unknown_; // by node: its row in the matrix, or none
    std::vector<std::uint32_t> nodes_;   // by row: the node
    std::vector<double> conductances_;
    std::unique_ptr<Factor> factor_;
    bool hard_ = false;              // the factorisation needed a shift, so it is a preconditioner only
    std::vector<double> missing_;    // by row: current, A
    std::vector<double> correction_; // by row: potential, V
    std::vector<double> passing_;    // by node: sum of the magnitudes of its currents, A
    std::vector<Potential> balance_; // by node: the current in minus the current out, A
    int symbolic_ = 0;
    int numeric_ = 0;
};

} // namespace trembler
