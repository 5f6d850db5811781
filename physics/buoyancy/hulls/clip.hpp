// Cutting convex polygons by the sides of a liquid.
#pragma once

#include "runtime/math/vec2.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace trembler {

/// A side of a convex liquid: inside is where dot(normal, p) <= offset.
struct Side {
    Vec2 normal;       ///< unit, outward
    double offset = 0; ///< m
};

/// A convex polygon that stores, for each of its edges, which side of the liquid cut it.
class ClippedPolygon {
public:
    static constexpr std::size_t capacity = 80; ///< enough for a body's corners and a liquid's sides
    static constexpr int own = -1;              ///< an edge of the polygon itself

    ClippedPolygon() = default;
    explicit ClippedPolygon(std::span<Vec2 const> corners) {
        for (Vec2 const corner : corners) {
            add(corner, own);
        }
    }
    /// Keeps the part inside (after Sutherland and Hodgman, 1974). The new edge, if there is one, gets `tag`.
    /// Rounding errors of the input change the result only by as much.
    void clip(Side const& side, int tag);

    [[nodiscard]] bool empty() const { return count_ < 3; }
    [[nodiscard]] std::span<Vec2 const> corners() const { return std::span(corners_).first(count_); }
    /// The tag of the edge from corner i to the next.
    [[nodiscard]] int tag(std::size_t i) const { return tags_[i]; }
    [[nodiscard]] Vec2 after(std::size_t i) const { return corners_[i + 1 == count_ ? 0 : i + 1]; }

private:
    void add(Vec2 corner, int tag) {
        if (count_ < capacity) {
            corners_[count_] = corner;
            tags_[count_++] = tag;
        }
    }

    std::array<Vec2, capacity> corners_{};
    std::array<int, capacity> tags_{};
    std::size_t count_ = 0;
};

} // namespace trembler
