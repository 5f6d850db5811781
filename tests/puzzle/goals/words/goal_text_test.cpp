#include "puzzle/goals/words/goal_text.hpp"
#include "tests/puzzle/goals/stage.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

TEST(GoalText, UsesTheAuthorsTextIfThereIsOne) {
    EXPECT_EQ(wordsOf(R"({"on": "lamp", "text": "Let there be light!"})"), "Let there be light!");
    EXPECT_EQ(wordsOf(R"({"on": "lamp", "for": 3, "text": "Let there be light!"})"), "Let there be light!");
    EXPECT_EQ(wordsOf(R"({"not": {"on": "lamp", "text": "Let there be light!"}})"), "Keep the lamp dark")
        << "the author's text does not state the opposite";
}

TEST(GoalText, StatesTheDuration) {
    EXPECT_EQ(wordsOf(R"({"on": "lamp", "for": 1})"), "Keep the lamp lit for 1 second");
    EXPECT_EQ(wordsOf(R"({"on": "lamp", "for": 0.25})"), "Keep the lamp lit for 0.25 seconds");
    EXPECT_EQ(wordsOf(R"({"not": {"on": "lamp", "for": 3}})"), "Do not keep the lamp lit for 3 seconds");
}

TEST(GoalText, NamesAnyOfSeveral) {
    EXPECT_EQ(wordsOf(R"({"on": ["lamp", "electromagnet", {"part": "desk lamp"}]})"),
              "Switch on the lamp, the electromagnet or a desk lamp");
}

TEST(GoalText, RecognisesLampsByTheirProperties) {
    EXPECT_EQ(wordsOf(R"({"on": "lantern"})"), "Light the lantern");
    EXPECT_EQ(wordsOf(R"({"on": "toy lamp"})"), "Switch on the toy lamp");
    EXPECT_EQ(wordsOf(R"({"on": {"part": "night light"}})"), "Light a night light");
    EXPECT_EQ(wordsOf(R"({"on": {"part": "desk lamp"}})"), "Switch on a desk lamp");
    EXPECT_EQ(wordsOf(R"({"on": ["lamp", "lantern", {"part": "night light"}]})"),
              "Light the lamp, the lantern or a night light");
    EXPECT_EQ(wordsOf(R"({"on": ["lamp", "toy lamp"]})"), "Switch on the lamp or the toy lamp");
    EXPECT_EQ(wordsOf(R"({"on": ["lamp", {"part": "desk lamp"}]})"), "Switch on the lamp or a desk lamp");
}

} // namespace
} // namespace trembler
