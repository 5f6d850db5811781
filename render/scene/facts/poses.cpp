#include "render/scene/facts/poses.hpp"

#include <algorithm>

namespace trembler::render {
namespace {

// The fastest speed that a body may be given is 10 km/s; an object that moves further in a frame was put
// there.
constexpr double farthestStep = 1e4 / 60.0;

Pose poseOf(Position const* position, Rotation const* rotation) {
    return {position == nullptr ? Point{} : Point{position->value.x, position->value.y},
            rotation == nullptr ? 0.0 : rotation->angle};
}

} // namespace

Pose poseOf(Facts const& facts) {
    return poseOf(facts.position, facts.rotation);
}

Pose poseOf(World const& world, ObjectId id) {
    return poseOf(world.find<Position>(id), world.find<Rotation>(id));
}

void Poses::remember(World const& world) {
    before_.clear();
    auto const* const positions = world.store().findColumn<Position>();
    if (positions == nullptr) {
        return;
    }
    auto const* const rotations = world.store().findColumn<Rotation>();
    for (std::size_t row = 0; row < positions->size(); ++row) {
        ObjectId const id = positions->owners()[row];
        before_.resize(std::max(before_.size(), id.index + std::size_t{1}));
        before_[id.index] = {
            id, poseOf(&positions->values()[row], rotations == nullptr ? nullptr : rotations->find(id))};
    }
}

Pose Poses::of(Facts const& facts, double alpha) const {
    Pose const now = poseOf(facts);
    if (facts.id.index >= before_.size() || before_[facts.id.index].id != facts.id) {
        return now;
    }
    Pose const& then = before_[facts.id.index].pose;
    if (!(length(now.at - then.at) <= farthestStep)) {
        return now;
    }
    double const share = std::clamp(alpha, 0.0, 1.0);
    return {now.at - (1 - share) * (now.at - then.at), now.angle - (1 - share) * (now.angle - then.angle)};
}

} // namespace trembler::render
