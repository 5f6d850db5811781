#include "physics/electricity/analyses/conductance_solver.hpp"

// Only the parts of Eigen under the Mozilla Public License; and no vectorisation, so that the order of
// arithmetic is the same with every compiler.
#define EIGEN_MPL2_ONLY
#define EIGEN_DONT_VECTORIZE
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace trembler {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
// The allowed error in Kirchhoff's law, as a share of the currents that pass a node. Rounding alone causes an
// error of about 1e-16 for each current.
constexpr double goodEnough = 1e-14;
// As a share of the largest current: the error at a node with less current than this is measured against this
// current.
constexpr double negligible = 1e-8;
// A refinement that leaves more than this share of the error counts as no progress.
constexpr double gain = 0.1;
constexpr int mostRefinements = 40;
constexpr int mostIterations = 60;

// a + b rounded, and the rounding error (Knuth).
ConductanceSolver::Potential exactSum(double a, double b) {
    double const sum = a + b;
    double const part = sum - a;
    return {sum, (a - (sum - part)) + (b - part)};
}

void add(ConductanceSolver::Potential& potential, double more) {
    auto const sum = exactSum(potential.high, more);
    potential = exactSum(sum.high, sum.low + potential.low);
}

double dot(std::vector<double> const& x, std::vector<double> const& y) {
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        sum += x[i] * y[i];
    }
    return sum;
}

using Matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

} // namespace

struct ConductanceSolver::Factor {
    /// The matrix entries to which an edge adds its conductance; none for a fixed end.
    struct Slots {
        std::uint32_t from = none;
        std::uint32_t to = none;
        std::uint32_t between = none;
    };
    Matrix matrix; // the lower triangle
    std::vector<Slots> slots;
    std::vector<std::uint32_t> diagonal;
    Eigen::SimplicialLDLT<Matrix, Eigen::Lower> ldlt;

    [[nodiscard]] std::uint32_t slot(std::uint32_t row, std::uint32_t column) {
        double const* const at =
            &matrix.coeffRef(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column));
        return static_cast<std::uint32_t>(at - matrix.valuePtr());
    }
    [[nodiscard]] bool good() const {
        if (ldlt.info() != Eigen::Success) {
            return false;
        }
        Vector const pivots = ldlt.vectorD();
        for (Eigen::Index i = 0; i < pivots.size(); ++i) {
            if (!(pivots[i] > 0) || !std::isfinite(pivots[i])) {
                return false;
            }
        }
        return true;
    }
};

ConductanceSolver::ConductanceSolver() : factor_(std::make_unique<Factor>()) {}
ConductanceSolver::~ConductanceSolver() = default;
ConductanceSolver::ConductanceSolver(ConductanceSolver&&) noexcept = default;
ConductanceSolver& ConductanceSolver::operator=(ConductanceSolver&&) noexcept = default;

void ConductanceSolver::setStructure(std::span<Edge const> edges, std::span<std::uint8_t const> fixed) {
    if (symbolic_ > 0 && std::equal(edges.begin(), edges.end(), edges_.begin(), edges_.end()) &&
        std::equal(fixed.begin(), fixed.end(), fixed_.begin(), fixed_.end())) {
        return;
    }
    edges_.assign(edges.begin(), edges.end());
    fixed_.assign(fixed.begin(), fixed.end());
    conductances_.clear();
    unknown_.assign(fixed_.size(), none);
    nodes_.clear();
    for (std::uint32_t v = 0; v < fixed_.size(); ++v) {
        if (fixed_[v] == 0) {
            unknown_[v] = static_cast<std::uint32_t>(nodes_.size());
            nodes_.push_back(v);
        }
    }
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(edges_.size() + nodes_.size());
    for (std::uint32_t r = 0; r < nodes_.size(); ++r) {
        entries.emplace_back(static_cast<int>(r), static_cast<int>(r), 1.0);
    }
    auto const lower = [&](Edge const& edge) {
        return std::minmax(unknown_[edge.from], unknown_[edge.to]); // column, row
    };
    for (Edge const& edge : edges_) {
        if (auto const [column, row] = lower(edge); row != none) {
            entries.emplace_back(static_cast<int>(row), static_cast<int>(column), 1.0);
        }
    }
    auto const size = static_cast<Eigen::Index>(nodes_.size());
    factor_->matrix.resize(size, size);
    factor_->matrix.setFromTriplets(entries.begin(), entries.end());
    factor_->diagonal.clear();
    for (std::uint32_t r = 0; r < nodes_.size(); ++r) {
        factor_->diagonal.push_back(factor_->slot(r, r));
    }
    factor_->slots.clear();
    for (Edge const& edge : edges_) {
        std::uint32_t const from = unknown_[edge.from];
        std::uint32_t const to = unknown_[edge.to];
        auto const [column, row] = lower(edge);
        factor_->slots.push_back({from == none ? none : factor_->diagonal[from],
                                  to == none ? none : factor_->diagonal[to],
                                  row == none ? none : factor_->slot(row, column)});
    }
    if (!nodes_.empty()) {
        factor_->ldlt.analyzePattern(factor_->matrix);
    }
    ++symbolic_;
}

void ConductanceSolver::setConductances(std::span<double const> conductances) {
    if (!conductances_.empty() &&
        std::equal(conductances.begin(), conductances.end(), conductances_.begin(), conductances_.end())) {
        return;
    }
    conductances_.assign(conductances.begin(), conductances.end());
    hard_ = false;
    if (nodes_.empty()) {
        return;
    }
    factorise(0);
    for (double shift = 1e-13; !factor_->good(); shift *= 10) {
        hard_ = true;
        factorise(shift);
    }
}

void ConductanceSolver::factorise(double shift) {
    double* const values = factor_->matrix.valuePtr();
    std::fill(values, values + factor_->matrix.nonZeros(), 0.0);
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        Factor::Slots const& slots = factor_->slots[e];
        double const g = conductances_[e];
        if (slots.from != none) {
            values[slots.from] += g;
        }
        if (slots.to != none) {
            values[slots.to] += g;
        }
        if (slots.between != none) {
            values[slots.between] -= g;
        }
    }
    for (std::uint32_t const d : factor_->diagonal) {
        values[d] += shift * values[d];
    }
    factor_->ldlt.factorize(factor_->matrix);
    ++numeric_;
}

void ConductanceSolver::flow(std::span<double const> emfs, std::span<Potential const> potentials,
                             std::vector<double>& currents) const {
    currents.resize(edges_.size());
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        Potential const& a = potentials[edges_[e].from];
        Potential const& b = potentials[edges_[e].to];
        Potential const drop = exactSum(a.high, -b.high);
        Potential const driven = exactSum(drop.high, emfs.empty() ? 0.0 : emfs[e]);
        currents[e] = conductances_[e] * (driven.high + (driven.low + (drop.low + (a.low - b.low))));
    }
}

// Computes the error in Kirchhoff's law at each node.
ConductanceSolver::Misses ConductanceSolver::misses(std::span<double const> injected,
                                                    std::span<double const> currents) {
    balance_.assign(fixed_.size(), {});
    passing_.assign(fixed_.size(), 0);
    for (std::size_t v = 0; v < injected.size(); ++v) {
        balance_[v].high = injected[v];
        passing_[v] = std::abs(injected[v]);
    }
    double largest = 0;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        double const size = std::abs(currents[e]);
        add(balance_[edges_[e].from], -currents[e]);
        add(balance_[edges_[e].to], currents[e]);
        passing_[edges_[e].from] += size;
        passing_[edges_[e].to] += size;
        largest = std::max(largest, size);
    }
    Misses worst;
    missing_.resize(nodes_.size());
    for (std::size_t r = 0; r < nodes_.size(); ++r) {
        std::uint32_t const v = nodes_[r];
        missing_[r] = balance_[v].high;
        // In a dead end only rounding errors flow, which need no precision.
        double const scale = std::max(passing_[v], negligible * largest);
        if (missing_[r] != 0) {
            worst.share = std::max(worst.share, std::abs(missing_[r]) / scale);
            worst.current = std::max(worst.current, std::abs(missing_[r]));
        }
    }
    return worst;
}

void ConductanceSolver::correct() {
    auto const size = static_cast<Eigen::Index>(nodes_.size());
    Eigen::Map<Vector>(correction_.data(), size) =
        factor_->ldlt.solve(Eigen::Map<Vector const>(missing_.data(), size));
}

void ConductanceSolver::multiply(std::vector<double> const& x, std::vector<double>& y) const {
    y.assign(nodes_.size(), 0);
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        std::uint32_t const from = unknown_[edges_[e].from];
        std::uint32_t const to = unknown_[edges_[e].to];
        double const i = conductances_[e] * ((from == none ? 0.0 : x[from]) - (to == none ? 0.0 : x[to]));
        if (from != none) {
            y[from] += i;
        }
        if (to != none) {
            y[to] -= i;
        }
    }
}

// Solves for the correction with the factorisation as preconditioner (Hestenes and Stiefel 1952).
void ConductanceSolver::conjugateGradients() {
    std::size_t const size = nodes_.size();
    std::vector<double> const wanted = missing_;
    std::vector<double> x(size, 0);
    std::vector<double> product;
    correct();
    std::vector<double> direction = correction_;
    double slope = dot(missing_, correction_);
    double const enough = 1e-20 * slope;
    for (int i = 0; i < mostIterations && slope > enough; ++i) {
        multiply(direction, product);
        double const curvature = dot(direction, product);
        if (!(curvature > 0)) {
            break;
        }
        double const step = slope / curvature;
        for (std::size_t r = 0; r < size; ++r) {
            x[r] += step * direction[r];
            missing_[r] -= step * product[r];
        }
        correct();
        double const next = dot(missing_, correction_);
        for (std::size_t r = 0; r < size; ++r) {
            direction[r] = correction_[r] + next / slope * direction[r];
        }
        slope = next;
    }
    missing_ = wanted;
    correction_ = std::move(x);
}

void ConductanceSolver::solve(std::span<double const> emfs, std::span<double const> injected,
                              std::vector<Potential>& potentials, std::vector<double>& currents) {
    potentials.resize(fixed_.size());
    for (std::uint32_t const v : nodes_) {
        potentials[v] = {};
    }
    flow(emfs, potentials, currents);
    if (nodes_.empty()) {
        return;
    }
    correction_.resize(nodes_.size());
    std::vector<Potential> best = potentials;
    Misses least = misses(injected, currents);
    bool hard = hard_;
    int vain = 0;
    for (int i = 0; i < mostRefinements && least.share > goodEnough && vain < 3; ++i) {
        if (hard) {
            conjugateGradients();
        } else {
            correct();
        }
        for (std::size_t r = 0; r < nodes_.size(); ++r) {
            add(potentials[nodes_[r]], correction_[r]);
        }
        flow(emfs, potentials, currents);
        Misses const now = misses(injected, currents);
        // At a node with almost no current the relative error stays 1 until all its digits are right; the
        // absolute error decreases from the first refinement on.
        if (now.share < gain * least.share || now.current < gain * least.current) {
            least = now;
            best = potentials;
            continue;
        }
        vain += hard ? 1 : 0;
        hard = true;
        if (now.share < least.share) {
            least = now;
            best = potentials;
        } else {
            potentials = best;
            flow(emfs, potentials, currents);
            (void)misses(injected, currents);
        }
    }
    potentials = best;
    flow(emfs, potentials, currents);
}

} // namespace trembler
