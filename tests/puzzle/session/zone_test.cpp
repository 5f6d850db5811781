// Parts must lie wholly in the areas for placing; compared with a count of points of a fine grid.
#include "puzzle/session/zone.hpp"
#include "tests/support/experiment.hpp"

#include <rapidcheck.h>

#include <cmath>

namespace trembler {
namespace {

Area boxArea(double x, double y, double width, double height) {
    return {.box = Box{{x, y}, {width, height}}, .corners = {}};
}

bool lies(Shape const& shape, Vec2 at, double angle, std::vector<Area> const& areas) {
    return liesWithin(PlacedShape{shape, at, angle}, areas, allowedOutside);
}

TEST(Zone, CountsTheWholeOutlineAndNotTheCentre) {
    Shape const plank{{boxPiece(2, 0.1)}};
    std::vector<Area> const area{boxArea(0, 0, 3, 1)};
    EXPECT_TRUE(lies(plank, {1.5, 0.5}, 0, area));
    EXPECT_TRUE(lies(plank, {1.005, 0.055}, 0, area)) << "5 mm more than the area has";
    EXPECT_FALSE(lies(plank, {0.98, 0.5}, 0, area)) << "2 cm stick out at the left";
    EXPECT_FALSE(lies(plank, {1.5, 0.5}, pi / 2, area)) << "upright it is higher than the area";
    EXPECT_FALSE(lies(plank, {1.5, 0.5}, pi / 4, area));
    EXPECT_FALSE(lies(plank, {9, 9}, 0, area));
    EXPECT_FALSE(lies(plank, {1.5, 0.5}, 0, {})) << "no area at all";
}

TEST(Zone, CountsRoundEndsAsRound) {
    std::vector<Area> const area{boxArea(-1, -1, 2, 2)};
    Shape const ball{{circlePiece(1)}};
    EXPECT_TRUE(lies(ball, {0, 0}, 0.3, area));
    EXPECT_FALSE(lies(ball, {0.05, 0}, 0.3, area));
    Shape const log{{capsulePiece(2.6, 0.3)}}; // from corner to corner of the area, with room for its ends
    EXPECT_TRUE(lies(log, {0, 0}, pi / 4, {boxArea(-1.02, -1.02, 2.04, 2.04)}));
    EXPECT_FALSE(lies(log, {0, 0}, 0, area));
}

TEST(Zone, MayReachAcrossAreasThatTouchEachOther) {
    Shape const plank{{boxPiece(2, 0.1)}};
    EXPECT_TRUE(lies(plank, {0, 0.5}, 0, {boxArea(-2, 0, 2, 1), boxArea(0, 0, 2, 1)}));
    EXPECT_FALSE(lies(plank, {0, 0.5}, 0, {boxArea(-2, 0, 1.9, 1), boxArea(0, 0, 2, 1)})) << "a gap of 10 cm";
}

TEST(Zone, CountsEveryPieceOfAShape) {
    Shape const two{{boxPiece(0.2, 0.2), boxPiece(0.2, 0.2, {1, 0})}};
    EXPECT_TRUE(lies(two, {0.5, 0.5}, 0, {boxArea(0, 0, 2, 1)}));
    EXPECT_FALSE(lies(two, {0.5, 0.5}, pi, {boxArea(0, 0, 2, 1)}));
}

/// A concave area: an L of two boxes, as a polygon.
Area const corner{.box = {}, .corners = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}};

bool inCorner(Vec2 p, double margin) {
    auto const in = [&](double width, double height) {
        return p.x >= -margin && p.x <= width + margin && p.y >= -margin && p.y <= height + margin;
    };
    return in(2, 1) || in(1, 2);
}

// Independent of outlines: a box lies inside if all points of a fine grid on it do.
TEST(Zone, AgreesWithAGridOfPointsInAConcaveArea) {
    EXPECT_TRUE(rc::check([] {
        double const width = *rc::gen::inRange(5, 150) * 0.01;
        double const height = *rc::gen::inRange(5, 60) * 0.01;
        Vec2 const at{*rc::gen::inRange(0, 200) * 0.01, *rc::gen::inRange(0, 200) * 0.01};
        double const angle = *rc::gen::inRange(-180, 180) * pi / 180;
        bool wholly = true; // with less than is allowed outside
        bool nearly = true; // with more
        constexpr int steps = 80;
        for (int i = 0; i <= steps; ++i) {
            for (int j = 0; j <= steps; ++j) {
                Vec2 const p = at + rotated({width * (static_cast<double>(i) / steps - 0.5),
                                             height * (static_cast<double>(j) / steps - 0.5)},
                                            angle);
                wholly = wholly && inCorner(p, 0);
                nearly = nearly && inCorner(p, 0.03);
            }
        }
        bool const found = lies(Shape{{boxPiece(width, height)}}, at, angle, {corner});
        RC_CLASSIFY(found);
        RC_ASSERT(!wholly || found);
        RC_ASSERT(nearly || !found);
    }));
}

// Areas that are too far away to matter are left out by their surrounding boxes.
TEST(Zone, DoesNotDependOnAreasFarAway) {
    EXPECT_TRUE(rc::check([] {
        double const width = *rc::gen::inRange(5, 150) * 0.01;
        Vec2 const at{*rc::gen::inRange(0, 200) * 0.01, *rc::gen::inRange(0, 200) * 0.01};
        double const angle = *rc::gen::inRange(-180, 180) * pi / 180;
        Shape const shape{{boxPiece(width, 0.2)}};
        bool const alone = lies(shape, at, angle, {corner});
        std::vector<Area> areas;
        for (int i = 0; i < 20; ++i) {
            Vec2 const far{5.0 + i, *rc::gen::inRange(-5, 5) * 1.0};
            areas.push_back({.box = {}, .corners = {far, far + Vec2{1, 0}, far + Vec2{0, 1}}});
            areas.push_back({.box = Box{far + Vec2{0, 20}, {1, 1}}, .corners = {}});
        }
        areas.insert(areas.begin() + *rc::gen::inRange(0, 40), corner);
        RC_ASSERT(lies(shape, at, angle, areas) == alone);
    }));
}

class ZoneOfALevel : public Experiment {
protected:
    void openWith(std::string const& placing) {
        open(readLevel(
            gameData().registry,
            JsonDocument::parse(
                R"({"version": 2, "title": "t", "world": {"bounds": [-4, -1, 8, 4]}, "objects": [], )" +
                    placing + R"("toolbox": [{"part": "plank", "count": 2},
                                               {"part": "seesaw", "count": 1}], "solutions": [{"name": "recorded",
                                               "placements": [{"part": "plank", "at": [0.1, 0.5]}]}]})",
                "level.json")));
    }
};

TEST_F(ZoneOfALevel, RefusesWhatSticksOutAndSaysSo) {
    openWith(R"("placing": [[0, 0, 3, 1]], )");
    EXPECT_TRUE(session().check({"plank", {1.5, 0.5}, 0, ""}).ok);
    EXPECT_EQ(session().check({"plank", {0.8, 0.5}, 0, ""}).why, "It would stick out of the area for parts.");
    EXPECT_EQ(session().check({"seesaw", {1.5, 0.9}, 0, ""}).why, "It would stick out of the area for parts.")
        << "of a composite part, its beam";
    EXPECT_EQ(session().check({"plank", {-1, 0.5}, 0, ""}).why, "Nothing can be placed there.");
    EXPECT_FALSE(session().place({"plank", {0.8, 0.5}, 0, ""}));
    auto const number = session().place({"plank", {1.5, 0.5}, 0, ""});
    ASSERT_TRUE(number);
    EXPECT_FALSE(session().move(*number, {1.5, 0.5}, pi / 2)) << "turned, it is higher than the area";
    EXPECT_FALSE(session().moveAll(std::vector{PlacedPart{*number, {"plank", {0.8, 0.5}, 0, ""}}}));
    EXPECT_TRUE(session().move(*number, {1.3, 0.4}, 0));
}

TEST_F(ZoneOfALevel, IsTheBoundsIfThereAreNoAreas) {
    openWith("");
    EXPECT_TRUE(session().check({"plank", {2.8, 0.5}, 0, ""}).ok);
    EXPECT_EQ(session().check({"plank", {3.5, 0.5}, 0, ""}).why, "It would stick out of the level.");
}

TEST_F(ZoneOfALevel, LoadsRecordedSolutionsByTheCentresOfTheirParts) {
    openWith(R"("placing": [[0, 0, 3, 1]], )");
    session().load(session().level().solutions.front());
    ASSERT_EQ(session().placed().size(), 1U);
    PlacedPart const plank = session().placed().front();
    EXPECT_FALSE(session().move(plank.number, {0.2, 0.5}, 0)) << "the player cannot put it so";
    EXPECT_TRUE(session().move(plank.number, {1.3, 0.5}, 0));
}

} // namespace
} // namespace trembler
