#include "physics/dynamics/engines/native/exact_rows.hpp"

// Only the parts of Eigen under the Mozilla Public License; and no vectorisation, so that the order of
// arithmetic is the same with every compiler.
#define EIGEN_MPL2_ONLY
#define EIGEN_DONT_VECTORIZE
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace trembler::native {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

constexpr double regularisation = 1e-11;
// Rows of which a pivot is less than this share of its diagonal say what others say already. Of the impulses
// that have the same effect the direct solution has an arbitrary one, as large as roundings over the
// regularisation; as soon as the bodies have turned it is a force. So these systems are regularised by this
// much, and the solution is approached by the proximal point method (R. T. Rockafellar 1976), which stays
// near the least of them, to this residual, in so many steps at most.
constexpr double leastPivot = 1e-10;
constexpr double proximal = 1e-4;
constexpr double mostResidual = 1e-13;
constexpr int mostProximalSteps = 60;
constexpr double slowest = 0.3; // a step that leaves more than this share of the last one's rest is the last
// Entries of the matrix per row beyond which it is a net that is too dense.
constexpr std::size_t densest = 60;

} // namespace

struct ExactRows::Factor {
    std::vector<std::uint32_t> signature;
    bool dense = false;
    bool used = true;
    Matrix matrix; // the lower triangle
    Eigen::SimplicialLDLT<Matrix, Eigen::Lower> ldlt;
    // Each pair of terms that share a body, and the matrix's entry for it.
    struct Pair {
        std::uint32_t row = 0;
        std::uint32_t column = 0;
        std::uint8_t rowTerm = 0;
        std::uint8_t columnTerm = 0;
        std::uint32_t entry = 0;
    };
    std::vector<Pair> pairs;
    std::vector<std::uint32_t> diagonal;
    Vector right;
    Vector found;
    Vector rest;
    bool redundant = false; // some rows follow from others

    void analyse(std::span<ExactRow const> rows);
    [[nodiscard]] bool hasRedundantRows() const;
    void solve();
};

bool ExactRows::Factor::hasRedundantRows() const {
    auto const& pivots = ldlt.vectorD();
    auto const& order = ldlt.permutationP().indices();
    for (std::size_t i = 0; i < diagonal.size(); ++i) {
        if (pivots[order[static_cast<Eigen::Index>(i)]] < leastPivot * matrix.valuePtr()[diagonal[i]]) {
            return true;
        }
    }
    return false;
}

void ExactRows::Factor::solve() {
    found = ldlt.solve(right);
    if (!redundant) {
        return;
    }
    double const enough = mostResidual * right.lpNorm<Eigen::Infinity>();
    double before = std::numeric_limits<double>::infinity();
    for (int step = 0; step < mostProximalSteps; ++step) {
        // What is left without the regularisation.
        rest = right - matrix.selfadjointView<Eigen::Lower>() * found;
        for (std::size_t i = 0; i < diagonal.size(); ++i) {
            auto const at = static_cast<Eigen::Index>(i);
            rest[at] += matrix.valuePtr()[diagonal[i]] * proximal / (1 + proximal) * found[at];
        }
        double const left = rest.lpNorm<Eigen::Infinity>();
        if (left <= enough || left > slowest * before) { // what contradicts others stays
            return;
        }
        before = left;
        found += ldlt.solve(rest);
    }
}

void ExactRows::Factor::analyse(std::span<ExactRow const> rows) {
    struct Share {
        SlotIndex slot;
        std::uint32_t row;
        std::uint8_t term;
    };
    std::vector<Share> shares;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (int n = 0; n < rows[i].count; ++n) {
            if (SlotIndex const slot = rows[i].terms[static_cast<std::size_t>(n)].slot; slot != noSlot) {
                shares.push_back({slot, static_cast<std::uint32_t>(i), static_cast<std::uint8_t>(n)});
            }
        }
    }
    std::stable_sort(shares.begin(), shares.end(),
                     [](Share const& x, Share const& y) { return x.slot < y.slot; });
    pairs.clear();
    for (std::size_t first = 0; first < shares.size();) {
        std::size_t last = first;
        for (; last < shares.size() && shares[last].slot == shares[first].slot; ++last) {
            for (std::size_t n = first; n <= last; ++n) {
                pairs.push_back({shares[last].row, shares[n].row, shares[last].term, shares[n].term, 0});
            }
        }
        first = last;
        if (pairs.size() > densest * rows.size() + 1000) {
            dense = true;
            return;
        }
    }
    std::vector<Eigen::Triplet<double>> all;
    for (Pair& pair : pairs) {
        if (pair.row < pair.column) {
            std::swap(pair.row, pair.column);
            std::swap(pair.rowTerm, pair.columnTerm);
        }
        all.emplace_back(static_cast<int>(pair.row), static_cast<int>(pair.column), 1.0);
    }
    auto const size = static_cast<Eigen::Index>(rows.size());
    for (int i = 0; i < static_cast<int>(rows.size()); ++i) {
        all.emplace_back(i, i, 1.0);
    }
    matrix.resize(size, size);
    matrix.setFromTriplets(all.begin(), all.end());
    auto const entry = [&](std::size_t i, std::size_t j) {
        double const* const at = &matrix.coeffRef(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
        return static_cast<std::uint32_t>(at - matrix.valuePtr());
    };
    for (Pair& pair : pairs) {
        pair.entry = entry(pair.row, pair.column);
    }
    diagonal.clear();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        diagonal.push_back(entry(i, i));
    }
    right.resize(size);
    ldlt.analyzePattern(matrix);
}

ExactRows::ExactRows() = default;
ExactRows::~ExactRows() = default;

ExactRows::Factor& ExactRows::factorOfRows() {
    signature_.clear();
    SlotIndex first = noSlot;
    for (ExactRow const& row : rows_) {
        for (int n = 0; n < row.count; ++n) {
            SlotIndex const slot = row.terms[static_cast<std::size_t>(n)].slot;
            signature_.push_back(slot);
            first = std::min(first, slot);
        }
        signature_.push_back(noSlot - 1); // ends the row
    }
    std::unique_ptr<Factor>& factor = factors_[first];
    if (factor == nullptr || factor->signature != signature_) {
        factor = std::make_unique<Factor>();
        factor->signature = signature_;
        factor->analyse(rows_);
    }
    factor->used = true;
    return *factor;
}

bool ExactRows::wereRedundant() {
    return !rows_.empty() && factorOfRows().redundant;
}

bool ExactRows::factorise(std::span<MovingState const> states, std::span<double const> follows) {
    Factor& factor = factorOfRows();
    factor_ = &factor;
    if (factor.dense) {
        return false;
    }
    double* const values = factor.matrix.valuePtr();
    std::fill(values, values + factor.matrix.nonZeros(), 0.0);
    for (Factor::Pair const& pair : factor.pairs) {
        ExactRow const& row = rows_[pair.row];
        ExactRow const& column = rows_[pair.column];
        if (!row.active || !column.active) {
            continue;
        }
        ExactTerm const& x = row.terms[pair.rowTerm];
        ExactTerm const& y = column.terms[pair.columnTerm];
        MovingState const& state = states[x.slot];
        double const both =
            state.inverseMass * dot(x.linear, y.linear) + state.inverseInertia * x.angular * y.angular;
        values[pair.entry] += follows[x.slot] * both;
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        double& value = values[factor.diagonal[i]];
        value = value > 0 ? value * (1 + regularisation) : 1;
    }
    factor.ldlt.factorize(factor.matrix);
    bool const contacts =
        std::any_of(rows_.begin(), rows_.end(), [](ExactRow const& row) { return row.contact; });
    factor.redundant = factor.ldlt.info() != Eigen::Success || (!contacts && factor.hasRedundantRows());
    if (factor.redundant) {
        for (std::uint32_t const entry : factor.diagonal) {
            values[entry] *= (1 + proximal) / (1 + regularisation);
        }
        factor.ldlt.factorize(factor.matrix);
    }
    return factor.ldlt.info() == Eigen::Success;
}

std::span<double const> ExactRows::solve(std::span<double const> right) {
    Factor& factor = *factor_;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        factor.right[static_cast<Eigen::Index>(i)] = rows_[i].active ? right[i] : 0;
    }
    factor.solve();
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        double& value = factor.found[static_cast<Eigen::Index>(i)];
        if (!rows_[i].active || !std::isfinite(value)) {
            value = 0;
        }
    }
    return {factor.found.data(), rows_.size()};
}

void ExactRows::tidy() {
    std::erase_if(factors_, [](auto const& entry) { return !std::exchange(entry.second->used, false); });
    factor_ = nullptr;
}

} // namespace trembler::native
