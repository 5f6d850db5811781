#include "physics/inverse_square/grid.hpp"

#include <algorithm>

namespace trembler::inverse_square {
namespace {

// Squares are numbered from this one on; receivers may lie outside of all sources.
constexpr double firstCell = 4;
constexpr double lastCell = 4294967280.0;
constexpr double mostCells = 2147483648.0; // across the sources
constexpr std::uint32_t widestBlock = 2; // columns that the receivers of one block may span beyond the first

std::uint64_t keyOf(std::uint32_t row, std::uint32_t column) {
    return (static_cast<std::uint64_t>(row) << 32U) | column;
}
std::uint32_t rowOf(std::uint64_t key) {
    return static_cast<std::uint32_t>(key >> 32U);
}
std::uint32_t columnOf(std::uint64_t key) {
    return static_cast<std::uint32_t>(key);
}

} // namespace

// A point outside of all squares is farther than the cutoff from every source, so any empty square is
// correct.
std::uint32_t Grid::cell(double offset) const {
    double const at = std::floor(offset * inverse_) + firstCell;
    if (!(at > 0)) {
        return 0;
    }
    return at >= lastCell ? static_cast<std::uint32_t>(lastCell) : static_cast<std::uint32_t>(at);
}

void Grid::orderByCell(Points const& points, std::vector<Ordered>& order) const {
    order.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        order[i] = {keyOf(cell(points.y[i] - origin_.y), cell(points.x[i] - origin_.x)),
                    static_cast<std::uint32_t>(i)};
    }
    sortByKeyAndPoint(points, order);
}

void Grid::build(Points const& sources, double cutoff) {
    cutoff_ = cutoff;
    origin_ = {};
    double width = cutoff;
    if (!sources.empty()) {
        auto const [left, right] = std::minmax_element(sources.x.begin(), sources.x.end());
        auto const [low, high] = std::minmax_element(sources.y.begin(), sources.y.end());
        origin_ = {*left, *low};
        width = std::max({cutoff, (*right - *left) / mostCells, (*high - *low) / mostCells});
    }
    inverse_ = 1 / width;
    orderByCell(sources, order_);
    copyInOrder(sources, order_, sources_);
}

void Grid::setReceivers(Points const& receivers) {
    orderByCell(receivers, receiverOrder_);
    copyInOrder(receivers, receiverOrder_, receivers_);
}

std::size_t Grid::firstAtOrAfter(std::uint64_t key) const {
    auto const found = std::lower_bound(order_.begin(), order_.end(), key,
                                        [](Ordered const& o, std::uint64_t k) { return o.key < k; });
    return static_cast<std::size_t>(found - order_.begin());
}

void Grid::add(std::size_t begin, std::size_t end, double inner, double softening2, std::span<Vec2> totals,
               std::span<double> stiffness) const {
    Kernels const& run = kernels();
    Window const window(inner, cutoff_);
    Block block;
    for (std::size_t i = begin; i < end;) {
        std::uint64_t const key = receiverOrder_[i].key;
        std::uint32_t const row = rowOf(key);
        std::size_t past = i + 1;
        while (past < end && past < i + blockSize && rowOf(receiverOrder_[past].key) == row &&
               columnOf(receiverOrder_[past].key) - columnOf(key) <= widestBlock) {
            ++past;
        }
        std::uint32_t const first = std::max(columnOf(key), 1U) - 1;
        std::uint32_t const last = columnOf(receiverOrder_[past - 1].key) + 1;
        auto const at = [i](std::size_t k) { return i + k; };
        auto const totalRow = [&](std::size_t k) { return receiverOrder_[i + k].row; };
        fillBlock(block, receivers_, totals, past - i, at, totalRow);
        // Sources in the range that are beyond a receiver's cutoff add nothing to its sum.
        for (std::uint32_t r = std::max(row, 1U) - 1; r <= row + 1; ++r) {
            run.addWindowed(sources_, firstAtOrAfter(keyOf(r, first)), firstAtOrAfter(keyOf(r, last) + 1),
                            softening2, window, block);
        }
        emptyBlock(block, totals, stiffness, past - i, totalRow);
        i = past;
    }
}

} // namespace trembler::inverse_square
