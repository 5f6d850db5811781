#include "puzzle/goals/words/english.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

TEST(English, MakesArticlesPluralsAndLists) {
    EXPECT_EQ(withArticle("lamp"), "the lamp");
    EXPECT_EQ(withArticle("object 1"), "object 1");
    EXPECT_EQ(withArticle("Bob"), "Bob");
    EXPECT_EQ(withIndefiniteArticle("iron ball"), "an iron ball");
    EXPECT_EQ(withIndefiniteArticle("steel bar"), "a steel bar");
    EXPECT_EQ(pluralOf("battery"), "batteries");
    EXPECT_EQ(pluralOf("box"), "boxes");
    EXPECT_EQ(pluralOf("switch"), "switches");
    EXPECT_EQ(pluralOf("key"), "keys");
    EXPECT_EQ(pluralOf("battery +"), "battery +");
    EXPECT_EQ(enumerated({"a", "b", "c"}, "or"), "a, b or c");
    EXPECT_EQ(enumerated({"a"}, "or"), "a");
    EXPECT_EQ(numberWord(0), "no");
    EXPECT_EQ(numberWord(12), "twelve");
    EXPECT_EQ(numberWord(13), "13");
}

TEST(English, ConvertsBetweenSentencesAndClauses) {
    EXPECT_EQ(capitalised("light the lamp"), "Light the lamp");
    EXPECT_EQ(capitalised("LEDs"), "LEDs");
    EXPECT_EQ(capitalised(""), "");
    EXPECT_EQ(asClause("Make light. "), "make light");
    EXPECT_EQ(asClause("LED on"), "LED on");
    EXPECT_EQ(asClause("..."), "");
}

} // namespace
} // namespace trembler
