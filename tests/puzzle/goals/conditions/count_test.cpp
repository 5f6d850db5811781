#include "tests/puzzle/goals/stage.hpp"

#include <gtest/gtest.h>

#include <array>

namespace trembler {
namespace {

TEST(CountCondition, CountsTheObjectsThatSatisfyACondition) {
    GoalStage stage(
        R"({"count": {"of": {"part": "iron ball"}, "at_least": 2, "that": {"touching": ["it", "floor"],
        "for": 0.05}}})");
    stage.touch("ball a", "floor");
    stage.touch("crate", "floor");
    stage.step(5);
    EXPECT_FALSE(stage.judge().solved());
    EXPECT_DOUBLE_EQ(stage.judge().status()[0].progress, 0.5);
    stage.touch("ball b", "floor");
    stage.step(2);
    EXPECT_FALSE(stage.judge().solved()); // the time is counted for each of them
    stage.step();
    EXPECT_TRUE(stage.judge().solved());
}

TEST(CountCondition, ComparesTheirNumberAsStated) {
    struct Case {
        char const* quantity;
        char const* met; // the verdict with none, one, two and three of them on
        char const* progress;
    };
    for (Case const& c : {Case{"at_least", "0011", "0 .5 1 1"}, Case{"at_most", "1110", "1 1 1 0"},
                          Case{"exactly", "0010", "0 .5 1 1"}}) {
        std::string met;
        std::string progress;
        for (int on = 0; on <= 3; ++on) { // a stage for each, because a solved goal stays solved
            GoalStage stage(R"({"count": {"of": ["lamp", "lamp 2", "electromagnet"], ")" +
                            std::string(c.quantity) + R"(": 2, "that": {"on": "it"}}})");
            std::array<char const*, 3> const all{"lamp", "lamp 2", "electromagnet"};
            for (std::size_t i = 0; i < static_cast<std::size_t>(on); ++i) {
                stage.turn(all[i], true);
            }
            stage.step();
            GoalStatus const& status = stage.judge().status()[0];
            met += status.met ? '1' : '0';
            progress += (on == 0 ? "" : " ") + std::string(status.progress == 0.5 ? ".5"
                                                           : status.progress == 1 ? "1"
                                                                                  : "0");
        }
        EXPECT_EQ(met, c.met) << c.quantity;
        EXPECT_EQ(progress, c.progress) << c.quantity;
    }
}

TEST(CountCondition, IsCausedByTheCountedObjects) {
    GoalStage stage(R"({"count": {"of": ["lamp", "lamp 2"], "at_least": 1, "that": {"on": "it"}}})");
    stage.turn("lamp", false, 3);
    stage.turn("lamp 2", true, 4);
    stage.step();
    EXPECT_EQ(stage.judge().causes(stage.world()), (std::vector<EventId>{{4}}));
    EXPECT_EQ(stage.judge().objects(0), (std::vector<ObjectId>{stage.id("lamp"), stage.id("lamp 2")}));
}

TEST(CountCondition, IsReadOrRefusedAtItsPlace) {
    EXPECT_TRUE(isRefused(R"({"count": {"of": "lamp", "that": {"on": "it"}}})", "does not state a number"));
    EXPECT_TRUE(isRefused(R"({"count": {"of": "lamp", "at_least": 1, "at_most": 1, "that": {"on": "it"}}})",
                          "/goals/count: states several numbers"));
    EXPECT_TRUE(isRefused(R"({"count": {"of": "lamp", "at_least": 0, "that": {"on": "it"}}})",
                          "/goals/count/at_least:"));
    EXPECT_EQ(refusalOf(R"({"count": {"of": "lamp", "at_most": 0, "that": {"on": "it"}}})"), "");
    EXPECT_TRUE(isRefused(R"({"count": {"of": "lamp", "at_least": 1}})", "/goals/count: 'that' is missing"));
    EXPECT_TRUE(isRefused(R"({"count": {"of": "lamp", "at_least": 1, "that": {"count": {"of": "lamp",
                              "at_least": 1, "that": {"on": "it"}}}}})",
                          "/goals/count/that/count: is inside another count"));
    EXPECT_TRUE(isRefused(R"({"all": [{"count": {"of": "lamp", "at_least": 1, "that": {"on": "it"}}},
                              {"on": "it"}]})",
                          "/goals/all/1/on: 'it' refers to no object here"));
}

TEST(CountCondition, IsRefusedIfTheNumberCanNeverBeReached) {
    std::string const that = R"(, "that": {"moved": {"object": "it", "by": 1}}}})";
    EXPECT_TRUE(isRefused(R"({"count": {"of": "crate", "at_least": 3)" + that,
                          "/goals: can never hold: it demands 3 objects, but there can be only 1"));
    EXPECT_TRUE(isRefused(R"({"count": {"of": ["crate", "crate", "object 1"], "exactly": 3)" + that,
                          "there can be only 2"));
    EXPECT_TRUE(
        isRefused(R"({"count": {"of": {"part": "iron ball"}, "at_least": 3)" + that, "there can be only 2"));
    EXPECT_EQ(refusalOf(R"({"count": {"of": {"part": "iron ball"}, "at_least": 2)" + that), "");
    EXPECT_EQ(refusalOf(R"({"count": {"of": "crate", "at_most": 3)" + that), "");
}

TEST(CountCondition, TextStatesTheNumber) {
    EXPECT_EQ(wordsOf(R"({"count": {"of": {"part": "iron ball"}, "at_least": 2,
                  "that": {"inside": {"object": "it", "area": [0, 0, 1, 1], "called": "the basket"}}}})"),
              "Bring at least two iron balls into the basket");
    EXPECT_EQ(wordsOf(R"({"count": {"of": ["lamp", "crate", "object 1"], "exactly": 1,
                  "that": {"moved": {"object": "it", "by": 1}}}})"),
              "Move exactly one of the lamp, the crate and object 1 by at least 1 m");
    EXPECT_EQ(wordsOf(R"({"count": {"of": ["lamp", "lamp 2"], "at_least": 2, "that": {"on": "it"}}})"),
              "Switch on both the lamp and lamp 2");
    EXPECT_EQ(wordsOf(R"({"not": {"count": {"of": {"part": "iron ball"}, "at_least": 1,
                  "that": {"touching": ["it", "floor"]}}}})"),
              "Bring no iron balls to the floor");
    EXPECT_EQ(wordsOf(R"({"not": {"count": {"of": {"part": "iron ball"}, "at_most": 1,
                  "that": {"touching": ["it", "floor"]}}}})"),
              "Bring at least two iron balls to the floor");
    EXPECT_EQ(wordsOf(R"({"not": {"count": {"of": {"part": "iron ball"}, "exactly": 1,
                  "that": {"touching": ["it", "floor"]}}}})"),
              "Do not bring exactly one iron ball to the floor");
}

} // namespace
} // namespace trembler
