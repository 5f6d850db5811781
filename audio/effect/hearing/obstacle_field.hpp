// Which obstacles a straight line may meet, found without looking at all of them.
#pragma once

#include "audio/effect/hearing/obstacles.hpp"
#include "physics/box_tree.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace trembler {

/// Building it takes O(n log n), asking about O(log n) where obstacles are spread out. The obstacles must
/// outlive it. Once it is built, any number of threads may ask.
class ObstacleField {
public:
    explicit ObstacleField(std::span<Obstacle const> obstacles);

    [[nodiscard]] std::span<Obstacle const> all() const { return obstacles_; }
    /// Calls `visit`, in a fixed order, with the number of each obstacle whose bounds the line between two
    /// points touches, until it returns false; among them are all in which either point lies. The line meets
    /// no others. Returns whether `visit` never did.
    bool along(Vec2 from, Vec2 to, std::function<bool(std::uint32_t)> const& visit) const;

private:
    std::span<Obstacle const> obstacles_;
    BoxTree tree_;
};

} // namespace trembler
