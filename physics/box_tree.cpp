#include "physics/box_tree.hpp"

#include <numeric>

namespace trembler {
namespace {

constexpr std::uint32_t few = 4;

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
    for (std::uint32_t i = first; i < last; ++i) {
        bounds.include(boxes_[order_[i]]);
    }
    nodes_.push_back({bounds, first, last, 0});
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

} // namespace trembler
