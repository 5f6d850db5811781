// Which obstacles a straight line may meet, found without looking at all of them.
#pragma once

#include "audio/effect/obstacles.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace trembler {

/// A tree of bounding boxes over obstacles, halved along the longer side of what they fill. Building it takes
/// O(n log n), asking about O(log n) where obstacles are spread out. The obstacles must outlive it. Once it
/// is built, any number of threads may ask.
class ObstacleField {
public:
    explicit ObstacleField(std::span<Obstacle const> obstacles);

    [[nodiscard]] std::span<Obstacle const> all() const { return obstacles_; }
    /// The numbers, ascending, of all obstacles whose bounds the line between two points touches, among them
    /// all in which either point lies. What is not among them the line does not meet. `found` is emptied
    /// first.
    void along(Vec2 from, Vec2 to, std::vector<std::uint32_t>& found) const;

private:
    struct Box {
        Vec2 middle;
        Vec2 half;
    };
    struct Node {
        Box box;
        std::uint32_t begin = 0; ///< of order_
        std::uint32_t end = 0;
        std::uint32_t right = 0; ///< the second child, the first comes next; 0: a leaf
    };

    std::uint32_t build(std::uint32_t begin, std::uint32_t end);
    [[nodiscard]] static Box boxOf(Vec2 low, Vec2 high);
    [[nodiscard]] static bool touches(Box const& box, Vec2 middle, Vec2 half);

    std::span<Obstacle const> obstacles_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

} // namespace trembler
