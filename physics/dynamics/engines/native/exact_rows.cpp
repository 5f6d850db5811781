#include "physics/dynamics/engines/native/exact_rows.hpp"

// Only the parts of Eigen under the Mozilla Public License; and no vectorisation, so that the order of
// arithmetic is the same with every compiler.
#define EIGEN_MPL2_ONLY
#define EIGEN_DONT_VECTORIZE
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

namespace trembler::native {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

constexpr double regularisation = 1e-11;
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

    void analyse(std::span<ExactRow const> rows);
};

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
    return factor.ldlt.info() == Eigen::Success;
}

std::span<double const> ExactRows::solve(std::span<double const> right) {
    Factor& factor = *factor_;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        factor.right[static_cast<Eigen::Index>(i)] = rows_[i].active ? right[i] : 0;
    }
    factor.found = factor.ldlt.solve(factor.right);
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
