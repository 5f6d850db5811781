#include "runtime/level/build/placing.hpp"
#include "tests/levels/level_kit.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace trembler {
namespace {

// Counting parts as they come says of each placement what a look at all those before it says.
TEST(PlacementCount, SaysOfEachPlacementWhatALookAtAllBeforeItSays) {
    LevelFile const level = readLevel(levelKit().registry, JsonDocument::parse(sampleLevel(), "sample.json"));
    rc::check([&] {
        std::vector<Placement> placements(*rc::gen::inRange<std::size_t>(0, 12));
        for (Placement& placement : placements) {
            placement.part = *rc::gen::element<std::string>("steel bar", "spanner", "crate", "no such part");
            placement.at = {static_cast<double>(*rc::gen::inRange(-10, 10)),
                            static_cast<double>(*rc::gen::inRange(-2, 6))};
        }
        PlacementCount count(level, levelKit().parts);
        for (std::size_t i = 0; i < placements.size(); ++i) {
            RC_ASSERT(count.add(placements[i]) ==
                      checkPlacement(level, levelKit().parts, std::span(placements).first(i), placements[i]));
        }
    });
}

} // namespace
} // namespace trembler
