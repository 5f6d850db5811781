// Inverse-square sums in O(n log n): a quadtree whose far parts are summed as wholes.
#pragma once

#include "physics/inverse_square/kernels.hpp"
#include "physics/inverse_square/spatial_order.hpp"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace trembler::inverse_square {

/// After Barnes and Hut (1986), with three differences: clusters have moments up to the second about the
/// centre of their absolute weights, so that weights of both signs that cancel in the sum still have an
/// effect; groups of neighbouring receivers walk through the tree together (Barnes 1990); and a cluster
/// counts as far if its *radius*, from its centre to its farthest point, is less than the opening angle times
/// the distance from its centre to the group's box. With an angle of 1 or less no receiver can lie inside a
/// cluster that it sums as a whole. With the angle 0 every pair is summed.
///
/// The tree depends on the points' places, weights and owners alone, not on the order of objects. Each group
/// has its own sums, so no bit depends on threads.
class Tree {
public:
    /// The number of receivers that walk together. A chunk of forRanges() is a whole number of groups.
    static constexpr std::size_t groupSize = 32;

    /// O(n log n).
    void build(Points const& sources);
    /// `ownElsewhere`: whether an owner may have sources in other places than the receiver's. Costs a search
    /// per receiver.
    void setReceivers(Points const& receivers, bool ownElsewhere);
    /// Adds the sums of the rows in [begin, end) of the ordered receivers to `totals`, whose order is the
    /// receivers' as given, and to `stiffness`, if not empty, how much they vary (see addAllPairs()); `begin`
    /// is a multiple of groupSize. Different ranges may be computed at the same time.
    void add(std::size_t begin, std::size_t end, double openingAngle, double softening2,
             std::span<Vec2> totals, std::span<double> stiffness = {}) const;

    [[nodiscard]] std::size_t nodes() const { return nodes_.size(); }

private:
    struct Node {
        Cluster cluster;
        double radius = 0; // m, no source lies farther from the centre
        std::uint32_t begin = 0;
        std::uint32_t end = 0;  // of its sources, in order
        std::uint32_t skip = 0; // the node after its last descendant
    };
    struct Box {
        Vec2 low;
        Vec2 high;
    };
    struct Lists;

    std::uint32_t grow(std::uint32_t begin, std::uint32_t end);
    void sumLeaf(Node& node) const;
    void sumChildren(std::uint32_t at);
    void ownOutside(std::size_t begin, std::size_t end, Box const& box,
                    std::vector<std::uint32_t>& own) const;
    void walk(Box const& box, double openingAngle, Lists& lists) const;

    std::vector<Ordered> order_;                          // of the sources
    Points sources_;                                      // in order
    std::vector<Node> nodes_;                             // parents before children
    std::vector<std::pair<double, std::uint32_t>> owned_; // owner and row of the ordered sources, ascending

    std::vector<Ordered> receiverOrder_;
    Points receivers_; // in order
    bool ownElsewhere_ = false;
};

} // namespace trembler::inverse_square
