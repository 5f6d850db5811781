#include "audio/effect/interactions/from_buoyancy.hpp"

#include "physics/depth.hpp"

namespace trembler {

void SoundFromBuoyancy::apply(Access& access) {
    auto const& positions = access.read<Position>();
    auto const& rotations = access.read<Rotation>();
    auto const& velocities = access.read<Velocity>();
    auto const angleOf = [&](ObjectId id) {
        Rotation const* const rotation = rotations.find(id);
        return rotation == nullptr ? 0 : rotation->angle;
    };
    wetNow_.clear();
    for (Immersions::Entry const& entry : access.read<Immersions>().entries) {
        std::pair const pair{entry.object, entry.liquid};
        wetNow_[pair] = entry.wet.area;
        auto const before = wet_.find(pair);
        double const gained = entry.wet.area - (before == wet_.end() ? 0 : before->second);
        Velocity const* const velocity = velocities.find(entry.object);
        Position const* const object = positions.find(entry.object);
        Position const* const liquid = positions.find(entry.liquid);
        if (access.firstTime() || !(gained > 0) || velocity == nullptr || object == nullptr ||
            liquid == nullptr) {
            continue;
        }
        double const speed = -dot(velocity->value, entry.up);
        if (!(speed > slowest)) {
            continue;
        }
        double const momentum = entry.density * gained * worldDepth * speed;
        double const turn = -angleOf(entry.liquid);
        access.call(Strike{entry.liquid, entry.object, rotated(object->value - liquid->value, turn),
                           rotated(-entry.up, turn), momentum, contact, 0},
                    entry.event);
    }
    wet_.swap(wetNow_);
}

} // namespace trembler
