#include "tests/puzzle/goals/stage.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

TEST(InsideCondition, HoldsWhileACentreIsInTheArea) {
    GoalStage stage(R"({"all": [{"inside": {"object": ["crate", "metal object"], "area": [1, 1, 2, 1]}},
        {"inside": {"object": "crate", "area": [[0, 0], [3, 0], [0, 3]]}}, {"on": "lamp"}]})");
    struct Place {
        Vec2 at;
        char const*
            met; // the verdicts of the box, the triangle, and the lamp, which keeps the level unsolved
    };
    for (Place const& place :
         {Place{{5, 0}, "000"}, Place{{1.5, 1.25}, "110"}, Place{{2.5, 1.25}, "100"},
          Place{{0.5, 0.5}, "010"}, Place{{1, 1}, "110"}, Place{{3, 2}, "100"}, Place{{3.01, 2}, "000"}}) {
        stage.put("crate", place.at);
        stage.step();
        EXPECT_EQ(stage.met(), place.met) << place.at.x << ", " << place.at.y;
    }
    stage.put("metal object", {2, 1.5}); // either of the two objects satisfies it
    stage.step();
    EXPECT_EQ(stage.met(), "100");
}

TEST(InsideCondition, IsCausedByTheContactsOfTheObject) {
    GoalStage stage(R"({"inside": {"object": "crate", "area": [4, -1, 2, 2]}})");
    stage.touch("crate", "floor", 7);
    stage.touch("metal object", "floor", 8);
    stage.step();
    EXPECT_TRUE(stage.judge().solved());
    EXPECT_EQ(stage.judge().causes(stage.world()), (std::vector<EventId>{{7}}));
    EXPECT_EQ(stage.judge().objects(0), (std::vector<ObjectId>{stage.id("crate")}));
}

TEST(InsideCondition, IsReadOrRefusedAtItsPlace) {
    EXPECT_TRUE(isRefused(R"({"inside": "crate"})", "/goals/inside: is "));
    EXPECT_TRUE(isRefused(R"({"inside": {"object": "crate"}})", "/goals/inside: 'area' is missing"));
    EXPECT_TRUE(isRefused(R"({"inside": {"area": [0, 0, 1, 1]}})", "/goals/inside: 'object' is missing"));
    EXPECT_TRUE(
        isRefused(R"({"inside": {"object": "crate", "area": [0, 0, -1, 1]}})", "/goals/inside/area/2:"));
    EXPECT_TRUE(isRefused(R"({"inside": {"object": "crate", "area": [0, 0, 1, 1], "called": 3}})",
                          "/goals/inside/called:"));
    EXPECT_TRUE(isRefused(R"({"inside": {"object": "crate", "area": [0, 0, 1, 1], "name": "a"}})",
                          "/goals/inside/name:"));
    EXPECT_TRUE(isRefused(R"({"inside": {"object": "idea", "area": [0, 0, 1, 1]}})",
                          "'idea' is nowhere, so it can never get anywhere"));
}

TEST(InsideCondition, IsRefusedIfNoObjectCanGetThere) {
    EXPECT_TRUE(isRefused(R"({"inside": {"object": "floor", "area": [5, 5, 1, 1]}})",
                          "/goals: can never hold: a fixed object never gets there"));
    EXPECT_EQ(refusalOf(R"({"inside": {"object": "floor", "area": [-1, -2, 2, 2]}})"), "") << "it is there";
    EXPECT_EQ(refusalOf(R"({"inside": {"object": ["floor", "crate"], "area": [5, 5, 1, 1]}})"), "");
    for (char const* const corners : {"[[0, 0], [1, 1], [2, 2]]", "[[0, 0], [0, 0], [0, 0]]",
                                      "[[0, 0], [5, 0.0001], [9, 0]]", "[[0, 0], [3, 0], [1, 0], [2, 0]]"}) {
        EXPECT_TRUE(
            isRefused(R"({"inside": {"object": "crate", "area": )" + std::string(corners) + "}}", "is flat"));
    }
    EXPECT_EQ(refusalOf(R"({"inside": {"object": "crate", "area": [[0, 0], [2, 0], [0, 2], [2, 2]]}})"), "")
        << "a bow tie";
}

TEST(InsideCondition, TextNamesTheArea) {
    EXPECT_EQ(wordsOf(R"({"inside": {"object": "crate", "area": [0, 0, 1, 1], "called": "the basket"}})"),
              "Bring the crate into the basket");
    EXPECT_EQ(wordsOf(R"({"inside": {"object": {"part": "iron ball"}, "area": [0, 0, 1, 1]}, "for": 0.5})"),
              "Keep an iron ball in the marked area for 0.5 seconds");
    EXPECT_EQ(wordsOf(R"({"not": {"inside": {"object": "crate", "area": [0, 0, 1, 1]}}})"),
              "Keep the crate out of the marked area");
}

} // namespace
} // namespace trembler
