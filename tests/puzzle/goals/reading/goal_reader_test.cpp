#include "puzzle/goals/reading/goal_reader.hpp"
#include "tests/puzzle/goals/stage.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

TEST(GoalReader, RequiresExactlyOneKind) {
    EXPECT_TRUE(isRefused("{}",
                          "/goals: states no condition; expected exactly one of the keys 'inside', "
                          "'touching', 'on', 'off', 'moved', 'count', 'all', 'any', 'not' or 'sequence'"));
    EXPECT_TRUE(isRefused(R"({"on": "lamp", "off": "lamp"})", "/goals: states several conditions"));
    EXPECT_TRUE(isRefused(R"({"no": {"on": "lamp"}})", "did you mean 'not'"));
    EXPECT_TRUE(isRefused(R"({"all": [[]]})",
                          "/goals/all/0: is a list of 0; expected a condition: an object with "
                          "one of the keys 'inside', 'touching'"));
}

TEST(GoalReader, ReadsTheKeysOfAllKinds) {
    EXPECT_TRUE(isRefused(R"({"on": "lamp", "for": -1})", "/goals/for: is -1"));
    EXPECT_TRUE(isRefused(R"({"on": "lamp", "for": 3601})", "/goals/for: is 3601"));
    EXPECT_TRUE(isRefused(R"({"on": "lamp", "text": 3})", "/goals/text: is 3"));
    EXPECT_TRUE(isRefused(R"({"on": "lamp", "id": ""})", "/goals/id:"));
    EXPECT_TRUE(isRefused(R"({"all": [{"on": "lamp", "id": "a"}, {"on": "lamp", "id": "a"}]})",
                          "/goals/all/1/id: there is already a goal with the id 'a'"));
}

TEST(GoalReader, ChecksTheNamesOfSelectors) {
    EXPECT_TRUE(
        isRefused(R"({"on": "lmap"})", "/goals/on: there is no object 'lmap' (did you mean 'lamp'?)"));
    EXPECT_TRUE(isRefused(R"({"on": []})", "/goals/on: is empty"));
    EXPECT_TRUE(isRefused(R"({"on": ["lamp", 3]})", "/goals/on/1: is 3"));
    EXPECT_TRUE(isRefused(R"({"on": "it"})", "/goals/on: 'it' refers to no object here"));
    EXPECT_TRUE(isRefused(R"({"on": {"part": "lead ball"}})",
                          "/goals/on/part: nothing in this level is made from the part 'lead ball'"));
    EXPECT_TRUE(isRefused(R"({"on": {"prt": "iron ball"}})", "did you mean 'part'"));
    EXPECT_EQ(refusalOf(R"({"touching": [["crate", {"part": "iron ball"}], {"part": "iron ball"}]})"), "");
}

TEST(GoalReader, SetsTheKindsAndPlacesOfConditions) {
    LevelFile level;
    level.objects.resize(1);
    level.objects[0].name = "bell";
    auto const document =
        JsonDocument::parse(R"({"all": [{"on": "bell"}, {"not": {"off": ["bell", "bell"]}}]})", "goals.json");
    Problems problems;
    Condition const all = GoalReader(level).condition(JsonNode(*document, document->root(), "", problems));
    EXPECT_NO_THROW(problems.throwIfAny());
    EXPECT_EQ(all.kind->key(), "all");
    ASSERT_EQ(all.children.size(), 2U);
    EXPECT_EQ(all.children[0].kind->key(), "on");
    ASSERT_EQ(all.children[1].children.size(), 1U);
    Condition const& off = all.children[1].children[0];
    EXPECT_EQ(off.kind->key(), "off");
    EXPECT_EQ(off.path, "/all/1/not");
    EXPECT_EQ(off.subject.path, "/all/1/not/off");
    EXPECT_EQ(off.subject.names, (std::vector<std::string>{"bell", "bell"}));
}

} // namespace
} // namespace trembler
