#include "insight/search/places.hpp"
#include "insight/trial/trial.hpp"
#include "tests/insight/support/tested_level.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace trembler::insight {
namespace {

TEST(Places, HaveTheGapInTheCircuitAndWhatLiesAcrossItSolvesTheLevel) {
    std::vector<Place> const places = placesOfInterest(firstContact());
    auto const gap = std::find_if(places.begin(), places.end(), [](Place const& place) {
        return place.kind == Place::Kind::gap && place.side == Place::Side::above &&
               place.near.find("left contact") != std::string::npos &&
               place.near.find("right contact") != std::string::npos;
    });
    ASSERT_NE(gap, places.end());
    EXPECT_NEAR(gap->at.x, -1.8, 1e-9) << "in the middle between them";
    for (char const* const part : {"steel bar", "spanner"}) {
        auto const placement = placedAt(firstContact(), *gap, part, 0);
        ASSERT_TRUE(placement.has_value()) << part;
        EXPECT_TRUE(tryOut(firstContact(), placing(part, placement->at, placement->angle), {}).solved)
            << part;
    }
}

TEST(Places, OfAllLevelsTakePartsWhereAPlayerCanPutThem) {
    std::size_t placed = 0;
    for (char const* const name : {"4-water/2-hold-it-up.json", "3-magnets/1-through-the-glass.json",
                                   "first/2-into-the-basket.json"}) {
        LevelUnderTest const level(gameData(), testedFile(name));
        std::vector<Place> const places = placesOfInterest(level);
        EXPECT_GT(places.size(), 10U) << name;
        for (Place const& place : places) {
            for (ToolboxEntry const& tool : level.level().toolbox) {
                if (auto const placement = placedAt(level, place, tool.part, 0)) {
                    Solution const solution = placing(tool.part, placement->at, placement->angle);
                    ASSERT_EQ(whyNotPlaced(level, solution), std::nullopt) << name << ", " << tool.part;
                    ++placed;
                }
            }
        }
    }
    EXPECT_GT(placed, 100U);
}

TEST(Places, AreOfEveryKindThatALevelOffers) {
    LevelUnderTest const level(gameData(), testedFile("4-water/2-hold-it-up.json"));
    std::vector<Place> const places = placesOfInterest(level);
    for (Place::Kind const kind : {Place::Kind::gap, Place::Kind::goal, Place::Kind::movable,
                                   Place::Kind::liquid, Place::Kind::fixed}) {
        EXPECT_TRUE(std::any_of(places.begin(), places.end(), [&](Place const& place) {
            return place.kind == kind;
        })) << static_cast<int>(kind);
    }
}

} // namespace
} // namespace trembler::insight
