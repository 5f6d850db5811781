// The linear algebra of nodal analysis: nodes joined by conductances, the potentials of some of them known.
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
/// factorisation is kept while the structure stays, the numeric one while the conductances stay, too.
///
/// One solution is as good as the condition of the matrix, up to 1e16 here, allows. So potentials are sums of
/// two numbers, the currents are computed edge by edge from differences that lose nothing, and their error in
/// Kirchhoff's law is solved for again, until nothing is gained (iterative refinement, Wilkinson 1963). Where
/// the factorisation is too poor for that, it serves conjugate gradients as a preconditioner.
///
/// The result depends on nothing but the arguments, bit for bit. Not thread-safe; one solver per thread.
class ConductanceSolver {
public:
    struct Edge {
        std::uint32_t from = 0;
        std::uint32_t to = 0;
        friend bool operator==(Edge const&, Edge const&) = default;
    };
    /// A potential in V: high + low, low being the rest that the nearest double leaves.
    struct Potential {
        double high = 0;
        double low = 0;
    };

    ConductanceSolver();
    ~ConductanceSolver();
    ConductanceSolver(ConductanceSolver&&) noexcept;
    ConductanceSolver& operator=(ConductanceSolver&&) noexcept;

    /// Which nodes are joined; edges may repeat, but must not join a node to itself. `fixed` is 1 for the
    /// nodes whose potential is given; every other must have a way to one of them.
    void setStructure(std::span<Edge const> edges, std::span<std::uint8_t const> fixed);
    /// Siemens, by edge; all above zero and finite.
    void setConductances(std::span<double const> conductances);
    /// Solves. `emfs` (V) raise the potential along an edge from `from` to `to`: i = g (V_from - V_to + emf).
    /// `injected` (A) flows into each node from outside. `potentials` comes with those of the fixed nodes.
    /// Afterwards `currents` are along the edges, in A.
    void solve(std::span<double const> emfs, std::span<double const> injected,
               std::vector<Potential>& potentials, std::vector<double>& currents);

    /// How often there was something new to do, for tests and benchmarks.
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
    bool hard_ = false;              // factorising took a shift: the factorisation is a preconditioner only
    std::vector<double> missing_;    // by row: current, A
    std::vector<double> correction_; // by row: potential, V
    std::vector<double> passing_;    // by node: sum of the sizes of the currents at it, A
    std::vector<Potential> balance_; // by node: the current that flows in and does not flow out, A
    int symbolic_ = 0;
    int numeric_ = 0;
};

} // namespace trembler
