// Finds the obstacles that a straight line may meet, without testing all of them.
#pragma once

#include "audio/effect/hearing/obstacles.hpp"
#include "physics/box_tree.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace trembler {

/// Building it takes O(n log n), a query about O(log n) if obstacles are spread out. The obstacles must
/// outlive it. Queries are thread-safe.
class ObstacleField {
public:
    explicit ObstacleField(std::span<Obstacle const> obstacles);

    [[nodiscard]] std::span<Obstacle const> all() const { return obstacles_; }
    /// Calls `visit`, in a fixed order, with the number of each obstacle whose bounds the line between two
    /// points touches, until it returns false. These include all obstacles that contain either point; the
    /// line meets no others. Returns false if `visit` did.
    bool along(Vec2 from, Vec2 to, std::function<bool(std::uint32_t)> const& visit) const;

private:
    std::span<Obstacle const> obstacles_;
    BoxTree tree_;
};

} // namespace trembler
