// Two interactions connect the same pair of objects, (Electricity <- Sound) by a sensor and (Electricity <-
// Rotation) by a generator: neither takes the other's connection away.
#include "tests/support/experiment.hpp"

#include <fmt/format.h>

namespace trembler {
namespace {

class SensorBesideGenerator : public Experiment {
protected:
    /// The frames in which the lamp is on: a steel ball falls onto stone, and the sensor between the dynamo
    /// and the mains hears it. `generator` is a property of the dynamo, which stands still.
    std::vector<std::uint64_t> lit(std::string const& generator) {
        open(readLevel(gameData().registry, JsonDocument::parse(fmt::format(R"({{
            "version": 2, "title": "t", "world": {{"gravity": [0, -9.81]}},
            "objects": [
              {{"name": "floor", "at": [0, -0.5], "properties": {{"shape": [{{"form": "box", "width": 10, "height": 1}}],
               "fixed": true, "material": "stone"}}}},
              {{"name": "ball", "at": [0, 1.5], "properties": {{"shape": [{{"form": "circle", "radius": 0.2}}],
               "material": "steel"}}}},
              {{"name": "mains", "at": [5, 5], "properties": {{"conductor": true, "electrical_source": true}}}},
              {{"name": "dynamo", "at": [3, 5], "properties": {{"conductor": true, {}
               "shape": [{{"form": "box", "width": 0.2, "height": 0.2}}]}}}},
              {{"name": "lamp", "at": [5, 6], "properties": {{"conductor": true, "electrical_device": true}}}},
              {{"name": "earth", "at": [5, 7], "properties": {{"conductor": true, "electrical_return": true}}}},
              {{"name": "ear", "at": [1, 1], "properties":
               {{"sound_sensor": {{"threshold_db": 40, "from": "dynamo", "to": "mains"}}}}}}],
            "joints": [{{"form": "hinge", "a": "dynamo", "at": [3, 5]}}],
            "connections": [["dynamo", "lamp"], ["lamp", "earth"]]}})",
                                                                            generator),
                                                                "level.json")));
        std::vector<std::uint64_t> frames;
        while (world().frame() < 90) {
            step();
            if (on("lamp")) {
                frames.push_back(world().frame());
            }
        }
        return frames;
    }
};

TEST_F(SensorBesideGenerator, AStandingGeneratorLeavesTheSensorsConnection) {
    auto const without = lit("");
    EXPECT_GT(without.size(), 30U);
    EXPECT_EQ(lit(R"("generator": {"source": "mains"},)"), without);
}

TEST_F(SensorBesideGenerator, ASilentSensorLeavesTheGeneratorsConnection) {
    EXPECT_EQ(lit(R"("generator": {"source": "mains", "speed_deg": 1}, "angular_velocity_deg": 720,)").size(),
              89U)
        << "from the second frame on";
}

} // namespace
} // namespace trembler
