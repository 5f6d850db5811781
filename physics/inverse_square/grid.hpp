// Inverse-square sums with a cutoff: O(n) times the number of neighbours within it.
#pragma once

#include "physics/inverse_square/kernels.hpp"
#include "physics/inverse_square/spatial_order.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace trembler::inverse_square {

/// Squares as wide as the cutoff; a receiver sums over its own square and the eight around it. Empty squares
/// take no memory, however wide the world is. The sums of one receiver are in an order that depends on the
/// places of its neighbours alone, so no bit depends on threads or on the order of objects.
///
/// A cutoff loses the far field: the missing part of the field of n like poles at the density p per m² grows
/// with n. Use the tree for such scenes.
class Grid {
public:
    /// `cutoff` > 0, m. O(n log n).
    void build(Points const& sources, double cutoff);
    void setReceivers(Points const& receivers);
    /// Adds the sums of the rows in [begin, end) of the ordered receivers to `totals`, whose order is the
    /// receivers' as given: pairs nearer than `inner` (< cutoff, m) in full, with a smooth decrease from
    /// there to zero at the cutoff. To `stiffness`, if not empty, it adds how much the sums vary (see
    /// addAllPairs()), without the decrease near the cutoff. Different ranges may be computed at the same
    /// time.
    void add(std::size_t begin, std::size_t end, double inner, double softening2, std::span<Vec2> totals,
             std::span<double> stiffness = {}) const;

private:
    [[nodiscard]] std::uint32_t cell(double offset) const;
    void orderByCell(Points const& points, std::vector<Ordered>& order) const;
    [[nodiscard]] std::size_t firstAtOrAfter(std::uint64_t key) const;

    double cutoff_ = 0;
    double inverse_ = 0; // 1/m, of the width of a square
    Vec2 origin_;
    std::vector<Ordered> order_; // of the sources: row of squares, then column
    Points sources_;             // in order
    std::vector<Ordered> receiverOrder_;
    Points receivers_; // in order
};

} // namespace trembler::inverse_square
