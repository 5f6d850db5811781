// Finds boxes by place, in a time that grows with the logarithm of their number.
#pragma once

#include "runtime/math/vec2.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace trembler {

/// A box with sides along the axes, in m.
struct Bounds {
    Vec2 lower;
    Vec2 upper;

    [[nodiscard]] bool meets(Bounds const& other) const {
        return lower.x <= other.upper.x && other.lower.x <= upper.x && lower.y <= other.upper.y &&
               other.lower.y <= upper.y;
    }
    void include(Bounds const& other) {
        lower = {std::min(lower.x, other.lower.x), std::min(lower.y, other.lower.y)};
        upper = {std::max(upper.x, other.upper.x), std::max(upper.y, other.upper.y)};
    }
};

/// The bounds of some points; there must be one.
[[nodiscard]] Bounds boundsOf(std::vector<Vec2> const& points);

/// A bounding volume hierarchy of boxes that do not move: nodes are halved along their longer extent until
/// few boxes are left. Takes n log n to build. Reads are thread-safe.
class BoxTree {
public:
    BoxTree() = default;
    explicit BoxTree(std::vector<Bounds> boxes);
    /// The numbers of all boxes that meet a box, touching included, ascending.
    void find(Bounds const& where, std::vector<std::uint32_t>& found) const {
        findIf([&](Bounds const& box) { return box.meets(where); }, found);
    }
    /// The numbers of all boxes for which `meets(box)` is true, ascending. If it is true for a box, it must
    /// be true for every box that encloses this one. `found` is emptied first.
    template <class Meets>
    void findIf(Meets&& meets, std::vector<std::uint32_t>& found) const;
    /// Calls `visit(number)` for the boxes for which `meets(box)` is true, as above, in a fixed order, until
    /// `visit` returns false. Returns false if it did.
    template <class Meets, class Visit>
    bool visitIf(Meets&& meets, Visit&& visit) const;
    /// How many boxes meet a box, touching included. If many boxes lie inside each other, this is much faster
    /// than finding them.
    [[nodiscard]] std::size_t count(Bounds const& where) const;
    /// The lowest number from `first` to below `end` of a box that meets `where`, touching included, and for
    /// which `holds` is true; nothing if there is none. `holds` is called in ascending order and no further
    /// than needed, so that the search is short even if all boxes meet.
    [[nodiscard]] std::optional<std::uint32_t>
    findFirst(Bounds const& where, std::uint32_t first, std::uint32_t end,
              std::function<bool(std::uint32_t)> const& holds) const;

private:
    struct Node {
        Bounds bounds;
        Bounds common;             // encloses all its boxes; lower above upper if there are none
        std::uint32_t lowest = 0;  // of the boxes in it
        std::uint32_t highest = 0; // likewise
        std::uint32_t first = 0;   // in order_
        std::uint32_t last = 0;
        std::uint32_t second = 0; // the other half's node; the first half's is the next one; 0: a leaf
    };
    void halve(std::uint32_t first, std::uint32_t last);

    std::vector<Bounds> boxes_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

template <class Meets>
void BoxTree::findIf(Meets&& meets, std::vector<std::uint32_t>& found) const {
    found.clear();
    visitIf(meets, [&](std::uint32_t number) {
        found.push_back(number);
        return true;
    });
    std::sort(found.begin(), found.end());
}

template <class Meets, class Visit>
bool BoxTree::visitIf(Meets&& meets, Visit&& visit) const {
    if (nodes_.empty()) {
        return true;
    }
    std::array<std::uint32_t, 64> open; // halving 2³² boxes goes no deeper than 32
    std::size_t count = 0;
    open[count++] = 0;
    while (count > 0) {
        std::uint32_t const at = open[--count];
        Node const& node = nodes_[at];
        if (!meets(node.bounds)) {
            continue;
        }
        if (node.second != 0) {
            open[count++] = node.second;
            open[count++] = at + 1;
            continue;
        }
        for (std::uint32_t i = node.first; i < node.last; ++i) {
            if (meets(boxes_[order_[i]]) && !visit(order_[i])) {
                return false;
            }
        }
    }
    return true;
}

} // namespace trembler
