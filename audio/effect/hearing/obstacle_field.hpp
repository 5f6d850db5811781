// Which obstacles a straight line may meet, found without looking at all of them.
#pragma once

#include "audio/effect/hearing/obstacles.hpp"
#include "physics/box_tree.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace trembler {

/// Building it takes O(n log n), asking about O(log n) where obstacles are spread out. The obstacles must
/// outlive it. Once it is built, any number of threads may ask.
class ObstacleField {
public:
    explicit ObstacleField(std::span<Obstacle const> obstacles);

    [[nodiscard]] std::span<Obstacle const> all() const { return obstacles_; }
    /// The numbers, ascending, of all obstacles whose bounds the line between two points touches, among them
    /// all in which either point lies. The line meets no others. `found` is emptied first.
    void along(Vec2 from, Vec2 to, std::vector<std::uint32_t>& found) const;

private:
    std::span<Obstacle const> obstacles_;
    BoxTree tree_;
};

} // namespace trembler
