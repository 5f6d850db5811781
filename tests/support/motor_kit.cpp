#include "tests/support/motor_kit.hpp"

#include "runtime/placement.hpp"

namespace trembler {
namespace {

constexpr double framesPerSecond = 60;

} // namespace

LevelFile turnedMotor(LevelFile level, double angle) {
    Vec2 const axis = level.findObject("main axle")->properties.find<Position>()->value;
    for (LevelObject& object : level.objects) {
        if (object.name == "main axle" || object.name.starts_with("spoke ")) {
            Vec2 const at = object.properties.find<Position>()->value;
            Rotation const* const rotation = object.properties.find<Rotation>();
            object.properties.set(Position{axis + rotated(at - axis, angle)});
            object.properties.set(Rotation{(rotation == nullptr ? 0 : rotation->angle) + angle});
        }
    }
    return level;
}

Tachometer::Tachometer(World const& world)
    : start_(world.find<Rotation>(world.store().find("main axle"))->angle) {}

void Tachometer::look(World const& world) {
    ObjectId const axis = world.store().find("main axle");
    double const now = (world.find<Rotation>(axis)->angle - start_) / (2 * pi);
    while (now >= static_cast<double>(marks_.size() + 1)) {
        double const part = (static_cast<double>(marks_.size() + 1) - turns_) / (now - turns_);
        marks_.push_back((static_cast<double>(world.frame() - 1) + part) / framesPerSecond);
    }
    turns_ = now;
    speeds_.push_back(world.find<AngularVelocity>(axis)->value);
}

std::vector<double> Tachometer::durations(double from) const {
    std::vector<double> durations;
    for (std::size_t i = 1; i < marks_.size(); ++i) {
        if (marks_[i - 1] >= from) {
            durations.push_back(marks_[i] - marks_[i - 1]);
        }
    }
    return durations;
}

std::vector<double> Tachometer::speeds(double from) const {
    auto const first = static_cast<std::ptrdiff_t>(from * framesPerSecond);
    return {speeds_.begin() + first, speeds_.end()};
}

} // namespace trembler
