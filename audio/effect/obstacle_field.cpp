#include "audio/effect/obstacle_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace trembler {
namespace {

constexpr std::uint32_t leafSize = 4;
constexpr double slack = 1e-6; // m: rounding must not make a line miss what it meets

} // namespace

ObstacleField::ObstacleField(std::span<Obstacle const> obstacles)
    : obstacles_(obstacles), order_(obstacles.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    if (!order_.empty()) {
        nodes_.reserve(obstacles.size());
        build(0, static_cast<std::uint32_t>(order_.size()));
    }
}

ObstacleField::Box ObstacleField::boxOf(Vec2 low, Vec2 high) {
    return {(low + high) / 2, (high - low) / 2 + Vec2{slack, slack}};
}

// A segment misses a box if one of three lines divides them: along x, along y, along itself.
bool ObstacleField::touches(Box const& box, Vec2 middle, Vec2 half) {
    Vec2 const apart = middle - box.middle;
    double const x = std::abs(half.x);
    double const y = std::abs(half.y);
    return std::abs(apart.x) <= box.half.x + x && std::abs(apart.y) <= box.half.y + y &&
           std::abs(cross(half, apart)) <= box.half.x * y + box.half.y * x + slack * slack;
}

std::uint32_t ObstacleField::build(std::uint32_t begin, std::uint32_t end) {
    auto const here = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    Vec2 low = obstacles_[order_[begin]].low;
    Vec2 high = obstacles_[order_[begin]].high;
    for (std::uint32_t i = begin; i < end; ++i) {
        Obstacle const& obstacle = obstacles_[order_[i]];
        low = {std::min(low.x, obstacle.low.x), std::min(low.y, obstacle.low.y)};
        high = {std::max(high.x, obstacle.high.x), std::max(high.y, obstacle.high.y)};
    }
    nodes_[here].box = boxOf(low, high);
    nodes_[here].begin = begin;
    nodes_[here].end = end;
    if (end - begin <= leafSize) {
        return here;
    }
    bool const wide = high.x - low.x >= high.y - low.y;
    auto const twiceMiddle = [&](std::uint32_t n) {
        Vec2 const sum = obstacles_[n].low + obstacles_[n].high;
        return wide ? sum.x : sum.y;
    };
    std::uint32_t const half = begin + (end - begin) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + half, order_.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) {
                         double const at = twiceMiddle(a);
                         double const other = twiceMiddle(b);
                         return at != other ? at < other : a < b;
                     });
    build(begin, half);
    std::uint32_t const right = build(half, end);
    nodes_[here].right = right;
    return here;
}

void ObstacleField::along(Vec2 from, Vec2 to, std::vector<std::uint32_t>& found) const {
    found.clear();
    if (nodes_.empty()) {
        return;
    }
    Vec2 const middle = (from + to) / 2;
    Vec2 const half = (to - from) / 2;
    std::array<std::uint32_t, 64> open; // halving 2³² obstacles goes no deeper than 32
    std::size_t count = 0;
    open[count++] = 0;
    while (count > 0) {
        Node const& node = nodes_[open[--count]];
        if (!touches(node.box, middle, half)) {
            continue;
        }
        if (node.right != 0) {
            auto const left = static_cast<std::uint32_t>(&node - nodes_.data()) + 1;
            open[count++] = node.right;
            open[count++] = left;
            continue;
        }
        for (std::uint32_t i = node.begin; i < node.end; ++i) {
            Obstacle const& obstacle = obstacles_[order_[i]];
            if (touches(boxOf(obstacle.low, obstacle.high), middle, half)) {
                found.push_back(order_[i]);
            }
        }
    }
    std::sort(found.begin(), found.end());
}

} // namespace trembler
