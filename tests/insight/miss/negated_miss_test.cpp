// Misses of conditions that should cease to hold.
#include "insight/miss/current/ways_of_current.hpp"
#include "insight/miss/negated_miss.hpp"
#include "insight/why/words/words.hpp"
#include "runtime/level/json/json_document.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/insight/support/explained_miss.hpp"
#include "tests/support/game_data.hpp"

#include <gtest/gtest.h>

namespace trembler::insight {
namespace negated_miss_test {
namespace {

LevelFile levelWith(std::string const& goals, std::string const& more = "") {
    std::string const text = R"({"version": 2, "title": "Negated",
  "world": {"gravity": [0, 0], "bounds": [-10, -10, 20, 20]},
  "objects": [{"name": "ball", "at": [0.5, 0.2], "properties":
                 {"shape": [{"form": "circle", "radius": 0.1}], "density": 1000}})" +
                             more + R"(], "goals": )" + goals + "}";
    return readLevel(gameData().registry, JsonDocument::parse(text, "negated.json"));
}

TEST(NegatedMiss, OfAnAreaIsTheWayOut) {
    Miss const miss =
        explainedMiss(levelWith(R"({"not": {"inside": {"object": "ball", "area": [0, 0, 2, 2]}}})"), 2);
    EXPECT_EQ(miss.lack, Lack::distance);
    EXPECT_NEAR(miss.by, 0.2, 1e-6);
    EXPECT_LT(miss.measure, 0.5);
    EXPECT_EQ(sentencesOf(miss, AnswerLanguage()).front(),
              "The ball was 20 cm short of where it should be, at the start.");
}

TEST(NegatedMiss, OfSeveralIsTheNearestOrTheMean) {
    std::string const near = R"({"inside": {"object": "ball", "area": [0, 0, 2, 2]}})";
    std::string const far = R"({"inside": {"object": "ball", "area": [-3, -3, 9, 9]}})";
    Miss const all = explainedMiss(levelWith(R"({"not": {"all": [)" + near + "," + far + "]}}"), 2);
    EXPECT_NEAR(all.by, 0.2, 1e-6) << "one of them suffices";
    Miss const any = explainedMiss(levelWith(R"({"not": {"any": [)" + near + "," + far + "]}}"), 2);
    EXPECT_NEAR(any.by, 3.2, 1e-6) << "each of them must end";
    EXPECT_GT(any.measure, all.measure);
}

/// The miss with a floor, that many boxes at rest on it, and the ball far from them.
Miss missOfBoxesOnAFloor(int boxes) {
    std::string more = R"(, {"name": "floor", "at": [0, -1], "properties":
        {"shape": [{"form": "box", "width": 12, "height": 0.5}], "fixed": true}})";
    std::string names;
    for (int i = 0; i < boxes; ++i) {
        names += (i > 0 ? ", " : "") + (R"("box )" + std::to_string(i) + '"');
        more += R"(, {"name": "box )" + std::to_string(i) + R"(", "at": [)" + std::to_string(i) +
                R"(, -0.655], "properties": {"shape": [{"form": "box", "width": 0.2, "height": 0.2}],
                "density": 500}})";
    }
    LevelFile const level =
        levelWith(R"({"not": {"touching": ["floor", [)" + names + R"(]]}, "for": 1})", more);
    return explainedMiss(level, 30);
}

TEST(NegatedMiss, OfATouchIsTheNumberOfPairsThatTouch) {
    Miss const one = missOfBoxesOnAFloor(1);
    EXPECT_EQ(one.lack, Lack::touches);
    EXPECT_EQ(one.by, 1);
    EXPECT_EQ(one.names, (std::vector<std::string>{"floor", "box 0"})) << "in the order of the goal";
    Miss const three = missOfBoxesOnAFloor(3);
    EXPECT_EQ(three.by, 3);
    EXPECT_GT(three.measure, one.measure) << "what has fewer to part is nearer";
    EXPECT_LT(three.measure, 1);
    EXPECT_TRUE(sentencesOf(one, AnswerLanguage()).front().starts_with("The floor still touched box 0"));
    EXPECT_TRUE(sentencesOf(three, AnswerLanguage())
                    .front()
                    .starts_with("The floor still touched box 0, one of 3 such pairs"));
}

/// The miss of a sequence that was completed at once and should not be.
TEST(NegatedMiss, OfASequenceThatIsDoneIsTheWholeWay) {
    Miss const miss = explainedMiss(
        levelWith(
            R"({"not": {"sequence": [{"inside": {"object": "ball", "area": [0, 0, 2, 2]}}]}, "for": 1})"),
        4);
    EXPECT_EQ(miss.lack, Lack::change);
    EXPECT_EQ(miss.by, 1);
}

/// A lamp between a source and a return, each with as many wires as stated.
LevelFile lampWith(int wiresToSource, int wiresToReturn) {
    std::string objects =
        R"({"name": "source", "at": [3, 0], "properties": {"conductor": true, "electrical_source": true}},
      {"name": "return", "at": [4, 0], "properties": {"conductor": true, "electrical_return": true}},
      {"name": "lamp", "at": [5, 0], "properties": {"conductor": true}})";
    std::string wires;
    auto const join = [&](std::string const& end, int count) {
        for (int i = 0; i < count; ++i) { // over a conductor of its own each
            std::string const name = end + " " + std::to_string(i);
            objects += R"(, {"name": ")" + name + R"(", "at": [6, )" + std::to_string(i) +
                       R"(], "properties": {"conductor": true}})";
            for (std::string const& other : {end, std::string("lamp")}) {
                wires += (wires.empty() ? "" : ", ") + (R"([")" + name + R"(", ")" + other + R"("])");
            }
        }
    };
    join("source", wiresToSource);
    join("return", wiresToReturn);
    std::string const text = R"({"version": 2, "title": "Off", "world": {"bounds": [-10, -10, 20, 20]},
      "objects": [)" + objects +
                             R"(], "connections": [)" + wires + R"(], "goals": {"off": "lamp", "for": 1}})";
    return readLevel(gameData().registry, JsonDocument::parse(text, "off.json"));
}

TEST(NegatedMiss, OfACurrentIsTheNumberOfConnectionsThatHoldIt) {
    for (auto const& [source, back, ways] : {std::tuple(1, 1, 1U), {1, 3, 1U}, {3, 2, 2U}, {3, 3, 3U}}) {
        LevelFile const level = lampWith(source, back);
        auto const world = buildWorld(gameData().registry, level, gameData().parts);
        world->step();
        EXPECT_EQ(waysOfCurrent(*world, world->store().find("lamp")).size(), ways);
        Miss const miss = explainedMiss(level, 4);
        EXPECT_EQ(miss.lack, Lack::ways);
        EXPECT_EQ(miss.by, ways);
        ASSERT_EQ(miss.ways.size(), ways);
        for (CurrentWay const& way : miss.ways) { // nearest to the lamp
            EXPECT_EQ(way.nameA, "lamp");
            EXPECT_EQ(way.nameB.rfind(source <= back ? "source " : "return ", 0), 0U) << way.nameB;
        }
    }
    EXPECT_EQ(sentencesOf(explainedMiss(lampWith(1, 3), 4), AnswerLanguage()).front(),
              "Current still flowed through the lamp: the connection between the lamp and source 0 held it, "
              "at the start.");
    EXPECT_EQ(sentencesOf(explainedMiss(lampWith(2, 3), 4), AnswerLanguage()).front(),
              "Current still flowed through the lamp: at least 2 connections held it, between the lamp and "
              "source 0, and between the lamp and source 1, at the start.");
    EXPECT_LT(explainedMiss(lampWith(1, 3), 4).measure, explainedMiss(lampWith(2, 3), 4).measure);
}

} // namespace
} // namespace negated_miss_test
} // namespace trembler::insight
