// Where objects are drawn: as the world has them, or between its last two frames.
#pragma once

#include "render/draw/geometry.hpp"
#include "render/scene/facts/facts.hpp"

#include <vector>

namespace trembler::render {

/// Radius, in metres, of the sign that stands for an object without a body.
inline constexpr double symbolRadius = 0.16;

/// Remembers where everything was before the last frame, so that a display that is faster than 60 Hz can show
/// the poses in between. Never touches the world.
class Poses {
public:
    /// Notes where everything is. Call it directly before each World::step.
    void remember(World const& world);
    void forget() { before_.clear(); }

    /// `alpha` (clamped to 0..1) of the way from the remembered place to the present one. The present one for
    /// an object that was not there before, or that jumped further than anything can move in a frame.
    [[nodiscard]] Pose of(Facts const& facts, double alpha = 1) const;

private:
    struct Entry {
        ObjectId id;
        Pose pose;
    };
    std::vector<Entry> before_; // by object index
};

/// Where the world has the object; the origin if it has no place.
[[nodiscard]] Pose poseOf(Facts const& facts);
[[nodiscard]] Pose poseOf(World const& world, ObjectId id);

} // namespace trembler::render
