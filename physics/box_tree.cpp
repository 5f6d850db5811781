#include "physics/box_tree.hpp"

#include <numeric>

namespace trembler {
namespace {

constexpr std::uint32_t few = 4;

bool isInside(Bounds const& inner, Bounds const& outer) {
    return outer.lower.x <= inner.lower.x && inner.upper.x <= outer.upper.x &&
           outer.lower.y <= inner.lower.y && inner.upper.y <= outer.upper.y;
}

Bounds commonTo(Bounds const& a, Bounds const& b) {
    return {{std::max(a.lower.x, b.lower.x), std::max(a.lower.y, b.lower.y)},
            {std::min(a.upper.x, b.upper.x), std::min(a.upper.y, b.upper.y)}};
}

bool isSomething(Bounds const& bounds) {
    return bounds.lower.x <= bounds.upper.x && bounds.lower.y <= bounds.upper.y;
}

} // namespace

Bounds boundsOf(std::vector<Vec2> const& points) {
    Bounds bounds{points.front(), points.front()};
    for (Vec2 const point : points) {
        bounds.include({point, point});
    }
    return bounds;
}

BoxTree::BoxTree(std::vector<Bounds> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
    std::iota(order_.begin(), order_.end(), std::uint32_t{0});
    if (!boxes_.empty()) {
        halve(0, static_cast<std::uint32_t>(boxes_.size()));
    }
}

void BoxTree::halve(std::uint32_t first, std::uint32_t last) {
    std::size_t const here = nodes_.size();
    Bounds bounds = boxes_[order_[first]];
    Bounds common = bounds;
    for (std::uint32_t i = first; i < last; ++i) {
        bounds.include(boxes_[order_[i]]);
        common = commonTo(common, boxes_[order_[i]]);
    }
    auto const [lowest, highest] = std::minmax_element(order_.begin() + first, order_.begin() + last);
    nodes_.push_back({bounds, common, *lowest, *highest, first, last, 0});
    if (last - first <= few) {
        return;
    }
    bool const wide = bounds.upper.x - bounds.lower.x >= bounds.upper.y - bounds.lower.y;
    auto const twiceCentre = [&](std::uint32_t box) {
        Vec2 const sum = boxes_[box].lower + boxes_[box].upper;
        return wide ? sum.x : sum.y;
    };
    std::uint32_t const middle = first + (last - first) / 2;
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                     [&](std::uint32_t a, std::uint32_t b) {
                         double const ofA = twiceCentre(a);
                         double const ofB = twiceCentre(b);
                         return ofA != ofB ? ofA < ofB : a < b;
                     });
    halve(first, middle);
    nodes_[here].second = static_cast<std::uint32_t>(nodes_.size());
    halve(middle, last);
}

std::size_t BoxTree::count(Bounds const& where) const {
    std::size_t sum = 0;
    std::vector<std::uint32_t> open;
    if (!nodes_.empty()) {
        open.push_back(0);
    }
    while (!open.empty()) {
        std::uint32_t const at = open.back();
        open.pop_back();
        Node const& node = nodes_[at];
        if (!node.bounds.meets(where)) {
            continue;
        }
        if (isInside(node.bounds, where) || (isSomething(node.common) && node.common.meets(where))) {
            sum += node.last - node.first; // all of its boxes meet it
        } else if (node.second != 0) {
            open.push_back(node.second);
            open.push_back(at + 1);
        } else {
            sum += static_cast<std::size_t>(
                std::count_if(order_.begin() + node.first, order_.begin() + node.last,
                              [&](std::uint32_t box) { return boxes_[box].meets(where); }));
        }
    }
    return sum;
}

std::optional<std::uint32_t> BoxTree::findFirst(Bounds const& where, std::uint32_t first, std::uint32_t end,
                                                std::function<bool(std::uint32_t)> const& holds) const {
    // A candidate for the next box, the lowest number first; a node comes before the boxes that it may hold.
    struct Next {
        std::uint32_t number; // of the box, or the lowest of the boxes in the node
        bool isBox;
        std::uint32_t node;
    };
    auto const later = [](Next const& a, Next const& b) {
        return a.number != b.number ? a.number > b.number : a.isBox && !b.isBox;
    };
    std::vector<Next> open;
    auto const add = [&](Next const& next) {
        open.push_back(next);
        std::push_heap(open.begin(), open.end(), later);
    };
    auto const addNode = [&](std::uint32_t at) {
        Node const& node = nodes_[at];
        if (node.lowest < end && node.highest >= first && node.bounds.meets(where)) {
            add({std::max(node.lowest, first), false, at});
        }
    };
    if (!nodes_.empty()) {
        addNode(0);
    }
    while (!open.empty()) {
        std::pop_heap(open.begin(), open.end(), later);
        Next const next = open.back();
        open.pop_back();
        if (next.isBox) {
            if (holds(next.number)) {
                return next.number;
            }
            continue;
        }
        Node const& node = nodes_[next.node];
        if (node.second != 0) {
            addNode(next.node + 1);
            addNode(node.second);
            continue;
        }
        for (std::uint32_t i = node.first; i < node.last; ++i) {
            std::uint32_t const box = order_[i];
            if (box >= first && box < end && boxes_[box].meets(where)) {
                add({box, true, 0});
            }
        }
    }
    return std::nullopt;
}

} // namespace trembler
