#include "tests/puzzle/goals/stage.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace trembler {
namespace {

using Json = nlohmann::json;

TEST(TouchingCondition, CountsContactsThatEndWithinAFrame) {
    GoalStage stage(
        R"({"sequence": [{"touching": ["ball a", "floor"]}, {"touching": ["ball a", "floor"]}]})");
    stage.step();
    stage.hit("ball a", "floor", 7);
    stage.step(3);
    EXPECT_FALSE(stage.judge().solved());
    stage.hit("ball a", "floor", 9);
    stage.step();
    EXPECT_EQ(stage.judge().solvedFrame(), 5U);
    std::vector<EventId> const causes = stage.judge().causes(stage.world());
    EXPECT_EQ(causes, (std::vector<EventId>{EventId{7}, EventId{9}}));
}

TEST(TouchingCondition, EndsWithTheLastContact) {
    GoalStage stage(R"({"not": {"touching": [["crate", "metal object"], "floor"]}})");
    stage.touch("crate", "floor", 3);
    stage.touch("metal object", "floor", 4);
    stage.step();
    stage.part("metal object", "floor", 5);
    stage.step();
    EXPECT_FALSE(stage.judge().solved()) << "the crate still touches it";
    stage.part("crate", "floor", 6);
    stage.step();
    EXPECT_TRUE(stage.judge().solved());
    EXPECT_EQ(stage.judge().causes(stage.world()), (std::vector<EventId>{{6}}));
}

// Looking up pairs of names and searching all contacts have the same result.
TEST(TouchingCondition, FindsContactsOfManyNamesAsPairByPair) {
    std::vector<std::string> const all{"floor", "metal object", "crate", "object 1", "ball a", "ball b"};
    EXPECT_TRUE(rc::check("many names are any two of them", [&] {
        auto const some = [&] {
            std::vector<std::string> names;
            for (std::string const& name : all) {
                if (*rc::gen::inRange(0, 2) == 0) {
                    names.push_back(name);
                }
            }
            return names.empty() ? all : names;
        };
        std::vector<std::string> const as = some();
        std::vector<std::string> const bs = some();
        Json pairs = Json::array();
        for (std::string const& a : as) {
            for (std::string const& b : bs) {
                if (a != b) {
                    pairs.push_back({{"touching", {a, b}}});
                }
            }
        }
        RC_PRE(!pairs.empty());
        GoalStage many(Json{{"touching", Json::array({Json(as), Json(bs)})}}.dump());
        GoalStage each(Json{{"any", pairs}}.dump());
        for (int frame = 0; frame < 3; ++frame) {
            for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
                std::string const a = *rc::gen::elementOf(all);
                std::string const b = *rc::gen::elementOf(all);
                int const how = *rc::gen::inRange(0, 3);
                for (GoalStage* const stage : {&many, &each}) {
                    if (a != b && how < 2) {
                        (how == 0 ? stage->touch(a, b) : stage->hit(a, b));
                    }
                }
            }
            many.step();
            each.step();
            RC_ASSERT(many.judge().solvedFrame() == each.judge().solvedFrame());
        }
    }));
}

TEST(TouchingCondition, IsReadOrRefusedAtItsPlace) {
    EXPECT_TRUE(isRefused(R"({"touching": ["crate"]})", "/goals/touching: is a list of 1"));
    EXPECT_TRUE(isRefused(R"({"touching": "crate"})", "a list of two selectors"));
    EXPECT_TRUE(
        isRefused(R"({"touching": ["crate", "flor"]})", "/goals/touching/1: there is no object 'flor'"));
    EXPECT_TRUE(isRefused(R"({"touching": ["crate", "lamp"]})",
                          "/goals/touching/1: 'lamp' has no shape, so it can never touch anything"));
}

TEST(TouchingCondition, IsRefusedIfThereIsNoOtherObjectToTouch) {
    EXPECT_TRUE(
        isRefused(R"({"touching": ["crate", "crate"]})", "/goals: can never hold: nothing touches itself"));
    EXPECT_TRUE(isRefused(R"({"touching": [["crate"], ["crate", "crate"]]})", "nothing touches itself"));
    EXPECT_TRUE(isRefused(
        R"({"count": {"of": ["crate", "floor"], "at_least": 1, "that": {"touching": ["it", "it"]}}})",
        "nothing touches itself"));
    for (char const* const goal :
         {R"({"touching": [["crate", "floor"], "crate"]})",
          R"({"touching": [{"part": "iron ball"}, {"part": "iron ball"}]})",
          R"({"count": {"of": ["crate", "floor"], "at_least": 1, "that": {"touching": ["it", "crate"]}}})"}) {
        EXPECT_EQ(refusalOf(goal), "") << goal;
    }
}

TEST(TouchingCondition, TextStatesTheDirectionOfTheMotion) {
    EXPECT_EQ(wordsOf(R"({"touching": ["metal object", "electromagnet"]})"),
              "Lift the metal object to the electromagnet");
    EXPECT_EQ(wordsOf(R"({"touching": ["electromagnet", "metal object"]})"),
              "Lift the metal object to the electromagnet");
    EXPECT_EQ(wordsOf(R"({"touching": ["metal object", "floor"]})"),
              "Bring the metal object down to the floor");
    EXPECT_EQ(wordsOf(R"({"touching": ["metal object", "object 1"]})"), "Bring the metal object to object 1");
    EXPECT_EQ(wordsOf(R"({"touching": [{"part": "iron ball"}, "crate"]})"),
              "Bring an iron ball to the crate");
    EXPECT_EQ(wordsOf(R"({"touching": ["metal object", "electromagnet"], "for": 2})"),
              "Keep the metal object touching the electromagnet for 2 seconds");
    EXPECT_EQ(wordsOf(R"({"not": {"touching": ["crate", "floor"]}})"), "Keep the crate away from the floor");
}

} // namespace
} // namespace trembler
