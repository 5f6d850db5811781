#include "tests/levels/devices/device_bench.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace trembler {

std::vector<SlightlyOff> slightlyOff() {
    return {{0, 0}, {0.02, 0}, {-0.02, 0}, {0, 2}, {0, -2}, {0.02, -2}, {-0.02, 2}};
}

void DeviceBench::put(std::string const& name, std::string const& part, Vec2 at, double angleDeg,
                      std::string const& more) {
    objects_.push_back(fmt::format(R"({{"name": "{}", "part": "{}", "at": [{}, {}], "angle_deg": {}{}{}}})",
                                   name, part, at.x, at.y, angleDeg, more.empty() ? "" : ", ", more));
}

void DeviceBench::make(std::string const& name, Vec2 at, std::string const& properties) {
    objects_.push_back(
        fmt::format(R"({{"name": "{}", "at": [{}, {}], "properties": {}}})", name, at.x, at.y, properties));
}

void DeviceBench::weigh(std::string const& name, Vec2 at, double kilograms) {
    make(name, at,
         fmt::format(R"({{"material": "wood", "mass": {}, "restitution": 0,
                          "shape": [{{"form": "box", "width": 0.2, "height": 0.2}}]}})",
                     kilograms));
}

void DeviceBench::lampAfter(std::string const& name, std::string const& terminal) {
    make(name, {3, 3.5 + 0.1 * static_cast<double>(objects_.size())},
         R"({"material": "glass", "conductor": true, "rated": {"power": 6, "voltage": 12}})");
    wire(terminal, name);
    wire(name, "minus");
}

void DeviceBench::wire(std::string const& a, std::string const& b) {
    wires_.push_back(fmt::format(R"(["{}", "{}"])", a, b));
}

void DeviceBench::input(std::uint64_t frame, std::string const& what) {
    inputs_.push_back(fmt::format(R"({{"frame": {}, {}}})", frame, what));
}

void DeviceBench::start() {
    std::string const level = fmt::format(
        R"({{"version": 2, "title": "bench", "world": {{"gravity": [0, -9.81], "bounds": [-5, -1, 10, 8]}},
            "objects": [
              {{"name": "floor", "at": [0, -0.15], "properties": {{"material": "stone", "fixed": true,
                "restitution": 0, "shape": [{{"form": "box", "width": 9, "height": 0.3}}]}}}},
              {{"name": "plus", "at": [-4, 3], "properties": {{"conductor": true, "electrical_source": true,
                "emf": {{"voltage": 12}}}}}},
              {{"name": "minus", "at": [4, 3], "properties": {{"conductor": true, "electrical_return": true}}}},
              {}],
            "connections": [{}],
            "solutions": [{{"name": "inputs", "expect": "unsolved", "frames": 100000, "inputs": [{}]}}]}})",
        fmt::join(objects_, ", "), fmt::join(wires_, ", "), fmt::join(inputs_, ", "));
    open(readLevel(gameData().registry, JsonDocument::parse(level, "bench.json")), "inputs");
    objects_.clear();
    wires_.clear();
    inputs_.clear();
}

int DeviceBench::framesOn(std::string const& name, std::uint64_t until) {
    int found = 0;
    while (world().frame() < until) {
        step();
        found += on(name) ? 1 : 0;
    }
    return found;
}

} // namespace trembler
