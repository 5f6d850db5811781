#include "puzzle/goals/goal_judge.hpp"
#include "puzzle/goals/goal_text.hpp"
#include "tests/puzzle/goals/stage.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

TEST(GoalText, SpeaksOfEveryCondition) {
    struct Case {
        char const* goal;
        char const* words;
    };
    for (Case const& c : {
             Case{R"({"touching": ["metal object", "electromagnet"]})",
                  "Lift the metal object to the electromagnet"},
             Case{R"({"touching": ["electromagnet", "metal object"]})",
                  "Lift the metal object to the electromagnet"},
             Case{R"({"touching": ["metal object", "floor"]})", "Bring the metal object down to the floor"},
             Case{R"({"touching": ["metal object", "object 1"]})", "Bring the metal object to object 1"},
             Case{R"({"on": "lamp", "for": 3})", "Keep the lamp lit for 3 seconds"},
             Case{R"({"on": "lamp"})", "Light the lamp"},
             Case{R"({"on": "electromagnet"})", "Switch on the electromagnet"},
             Case{R"({"off": "electromagnet", "for": 1})", "Keep the electromagnet off for 1 second"},
             Case{R"({"not": {"on": "lamp"}})", "Keep the lamp dark"},
             Case{R"({"not": {"off": "lamp"}})", "Keep the lamp lit"},
             Case{R"({"not": {"not": {"on": "lamp"}}})", "Light the lamp"},
             Case{R"({"inside": {"object": "crate", "area": [0, 0, 1, 1], "called": "the basket"}})",
                  "Bring the crate into the basket"},
             Case{R"({"inside": {"object": {"part": "iron ball"}, "area": [0, 0, 1, 1]}, "for": 0.5})",
                  "Keep an iron ball in the marked area for 0.5 seconds"},
             Case{R"({"not": {"inside": {"object": "crate", "area": [0, 0, 1, 1]}}})",
                  "Keep the crate out of the marked area"},
             Case{R"({"moved": {"object": "crate", "by": 0.5}})", "Move the crate by at least 0.5 m"},
             Case{R"({"moved": {"object": "crate", "by": 2, "towards": "up"}})",
                  "Lift the crate by at least 2 m"},
             Case{R"({"moved": {"object": "crate", "by": 2, "towards": "left"}, "for": 2})",
                  "Keep the crate at least 2 m to the left of where it was at the start for 2 seconds"},
             Case{R"({"not": {"moved": {"object": "crate", "by": 1}}})",
                  "Do not move the crate by 1 m or more"},
             Case{R"({"not": {"touching": ["crate", "floor"]}})", "Keep the crate away from the floor"},
             Case{R"({"count": {"of": {"part": "iron ball"}, "at_least": 2,
                      "that": {"inside": {"object": "it", "area": [0, 0, 1, 1], "called": "the basket"}}}})",
                  "Bring at least two iron balls into the basket"},
             Case{R"({"count": {"of": ["lamp", "lamp 2"], "at_least": 2, "that": {"on": "it"}}})",
                  "Switch on both the lamp and lamp 2"},
             Case{R"({"count": {"of": ["lamp", "crate", "object 1"], "exactly": 1,
                      "that": {"moved": {"object": "it", "by": 1}}}})",
                  "Move exactly one of the lamp, the crate and object 1 by at least 1 m"},
             Case{R"({"not": {"count": {"of": {"part": "iron ball"}, "at_least": 1,
                      "that": {"touching": ["it", "floor"]}}}})",
                  "Bring no iron balls to the floor"},
             Case{R"({"any": [{"on": "lamp"}, {"on": "electromagnet"}]})",
                  "Either light the lamp or switch on the electromagnet"},
             Case{R"({"all": [{"on": "lamp"}, {"on": "electromagnet"}], "for": 2})",
                  "Keep the lamp lit and keep the electromagnet on, both for 2 seconds"},
             Case{R"({"not": {"any": [{"on": "lamp"}, {"on": "electromagnet"}]}})",
                  "Keep the lamp dark and keep the electromagnet off"},
             Case{R"({"any": [{"sequence": [{"on": "lamp"}, {"off": "lamp"}]}, {"on": "electromagnet"}]})",
                  "Either first light the lamp, then put out the lamp, or switch on the electromagnet"},
             Case{R"({"any": [{"on": "lamp", "text": "Make light."}, {"on": "electromagnet"}]})",
                  "Either make light or switch on the electromagnet"},
             Case{R"({"on": "lamp", "text": "Let there be light!"})", "Let there be light!"},
         }) {
        GoalStage stage(c.goal);
        ASSERT_EQ(stage.judge().status().size(), 1U);
        EXPECT_EQ(stage.judge().status()[0].text, c.words) << c.goal;
    }
}

TEST(GoalText, MakesOneSentenceForEachGoal) {
    GoalStage stage(R"({"all": [{"on": "lamp", "id": "light"}, {"not": {"touching": ["crate", "floor"]}}]})");
    ASSERT_EQ(stage.judge().status().size(), 2U);
    EXPECT_EQ(stage.judge().status()[0].id, "light");
    EXPECT_EQ(stage.judge().status()[1].id, "goal 2");
    EXPECT_EQ(stage.judge().status()[1].text, "Keep the crate away from the floor");
}

TEST(GoalText, KnowsEnglish) {
    EXPECT_EQ(withArticle("lamp"), "the lamp");
    EXPECT_EQ(withArticle("object 1"), "object 1");
    EXPECT_EQ(withArticle("Bob"), "Bob");
    EXPECT_EQ(withIndefiniteArticle("iron ball"), "an iron ball");
    EXPECT_EQ(pluralOf("battery"), "batteries");
    EXPECT_EQ(pluralOf("box"), "boxes");
    EXPECT_EQ(pluralOf("switch"), "switches");
    EXPECT_EQ(pluralOf("key"), "keys");
    EXPECT_EQ(enumerated({"a", "b", "c"}, "or"), "a, b or c");
    EXPECT_EQ(numberWord(12), "twelve");
    EXPECT_EQ(numberWord(13), "13");
}

} // namespace
} // namespace trembler
