// A small world of parts, written in a line or two, for tests of the parts' behaviour.
#pragma once

#include "physics/dynamics/properties/body.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "runtime/placement.hpp"
#include "tests/levels/level_kit.hpp"

#include <fmt/format.h>

#include <memory>
#include <stdexcept>
#include <string>

namespace trembler {

/// Collects entries of a level; the first step builds the world. Names are those of the level's objects.
class PartTrial {
public:
    explicit PartTrial(std::string world = R"("gravity": [0, -9.81])") : world_(std::move(world)) {}

    /// Puts a part at a place in m; `properties` is the inside of a JSON object.
    PartTrial& put(std::string const& part, std::string const& name, Vec2 at, double degrees = 0,
                   std::string const& properties = "") {
        objects_ += fmt::format(
            R"({}{{"name": "{}", "part": "{}", "at": [{}, {}], "angle_deg": {}, "properties": {{{}}}}})",
            objects_.empty() ? "" : ", ", name, part, at.x, at.y, degrees, properties);
        return *this;
    }
    /// A fixed box of stone, 60 m wide and 1 m high, whose top is at this height in m.
    PartTrial& floor(double top = 0) {
        objects_ += fmt::format(
            R"({}{{"name": "floor", "at": [0, {}], "properties": {{"material": "stone", "fixed": true, "restitution": 0, "shape": [{{"form": "box", "width": 60, "height": 1}}]}}}})",
            objects_.empty() ? "" : ", ", top - 0.5);
        return *this;
    }
    /// Turns an object about its place with this many degrees a second.
    PartTrial& drive(std::string const& object, Vec2 at, double degreesPerSecond) {
        joints_ += fmt::format(
            R"({}{{"form": "hinge", "a": "{}", "at": [{}, {}], "motor": true, "motor_speed_deg": {}, "motor_strength": 5000}})",
            joints_.empty() ? "" : ", ", object, at.x, at.y, degreesPerSecond);
        return *this;
    }
    PartTrial& connect(std::string const& a, std::string const& b) {
        connections_ += fmt::format(R"({}["{}", "{}"])", connections_.empty() ? "" : ", ", a, b);
        return *this;
    }

    PartTrial& run(int frames) {
        if (built_ == nullptr) {
            std::string const text = fmt::format(
                R"({{"version": 2, "title": "t", "world": {{{}}}, "objects": [{}], "joints": [{}], "connections": [{}]}})",
                world_, objects_, joints_, connections_);
            LevelFile const level = readLevel(levelKit().registry, JsonDocument::parse(text, "trial.json"));
            built_ = buildWorld(levelKit().registry, level, levelKit().parts);
        }
        for (int frame = 0; frame < frames; ++frame) {
            built_->step();
        }
        return *this;
    }
    PartTrial& seconds(double time) { return run(static_cast<int>(time * 60 + 0.5)); }

    [[nodiscard]] Vec2 at(std::string const& name) const { return get<Position>(name).value; }
    [[nodiscard]] Vec2 velocity(std::string const& name) const { return get<Velocity>(name).value; }
    [[nodiscard]] double mass(std::string const& name) const { return get<Mass>(name).value; }
    /// In degrees; whole turns count.
    [[nodiscard]] double degrees(std::string const& name) const {
        return get<Rotation>(name).angle * 180 / 3.14159265358979323846;
    }
    [[nodiscard]] bool on(std::string const& name) const {
        auto const* const state = built_->find<ElectricalState>();
        return state != nullptr && state->isOn(built_->store().find(name));
    }
    template <class P>
    [[nodiscard]] P const& get(std::string const& name) const {
        P const* const value = built_->find<P>(built_->store().find(name));
        if (value == nullptr) {
            throw std::logic_error("no such property of " + name);
        }
        return *value;
    }

private:
    std::string world_;
    std::string objects_;
    std::string joints_;
    std::string connections_;
    std::unique_ptr<World> built_;
};

} // namespace trembler
