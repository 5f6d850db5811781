// Where objects are drawn: at their places in the world, or between those of its last two frames.
#pragma once

#include "render/draw/geometry.hpp"
#include "render/scene/facts/facts.hpp"

#include <vector>

namespace trembler::render {

/// Radius, in metres, of the sign that stands for an object without a body.
inline constexpr double symbolRadius = 0.16;

/// Remembers where every object was before the last frame, so that a display that is faster than 60 Hz can
/// show the poses in between. Never changes the world.
class Poses {
public:
    /// Remembers where every object is. Call it directly before each World::step.
    void remember(World const& world);
    void forget() { before_.clear(); }

    /// `alpha` (clamped to 0..1) of the way from the remembered place to the present one. The present one for
    /// an object that did not exist before, or that moved further than is possible in a frame.
    [[nodiscard]] Pose of(Facts const& facts, double alpha = 1) const;

private:
    struct Entry {
        ObjectId id;
        Pose pose;
    };
    std::vector<Entry> before_; // by object index
};

/// The object's pose in the world; the origin if it has no place.
[[nodiscard]] Pose poseOf(Facts const& facts);
[[nodiscard]] Pose poseOf(World const& world, ObjectId id);

} // namespace trembler::render
