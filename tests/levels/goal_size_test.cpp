// Depth and number of a level's goals: accepted at the limits, rejected with their place above them, and
// never read by unbounded recursion.
#include "puzzle/goals/level_schema.hpp"
#include "puzzle/goals/read_goals.hpp"
#include "runtime/level/json/limits.hpp"
#include "tests/levels/level_kit.hpp"
#include "tests/levels/schema_validator.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

std::string const leaf = R"({"on": "ball"})";

std::string levelWithGoals(std::string const& goals) {
    return R"({"version": 2, "title": "t", "objects": [{"name": "ball"}], "goals": )" + goals + "}";
}

std::string repeated(std::string_view text, std::size_t count) {
    std::string all;
    all.reserve(text.size() * count);
    for (std::size_t i = 0; i < count; ++i) {
        all += text;
    }
    return all;
}
/// A leaf inside `count` negations.
std::string nested(std::size_t count) {
    return repeated(R"({"not": )", count) + leaf + repeated("}", count);
}
/// `{"<kind>": [...]}` of `count` conditions.
std::string listOf(std::string const& kind, std::size_t count, std::string const& condition = leaf) {
    return "{\"" + kind + "\": [" + condition + repeated(", " + condition, count - 1) + "]}";
}

struct Verdict {
    std::optional<Condition> goals;
    std::vector<Diagnostic> problems; ///< by place
};
Verdict outcomeOf(std::string const& goals) {
    try {
        return {
            readGoals(readLevel(levelKit().registry, JsonDocument::parse(levelWithGoals(goals), "l.json"))),
            {}};
    } catch (InputError const& error) {
        return {std::nullopt, {error.diagnostics().begin(), error.diagnostics().end()}};
    }
}

std::size_t countOf(Condition const& condition) {
    std::size_t count = 1;
    for (Condition const& child : condition.children) {
        count += countOf(child);
    }
    return count;
}

// The level itself is the outermost object, and the leaf the innermost.
constexpr std::size_t deepest = limits::depth - 2;

TEST(GoalSize, GoalsMayNestAsDeepAsAFileMay) {
    Verdict const read = outcomeOf(nested(deepest));
    ASSERT_TRUE(read.goals.has_value()) << read.problems.at(0).message;
    EXPECT_EQ(countOf(*read.goals), deepest + 1);
    Condition const* innermost = &*read.goals;
    while (!innermost->children.empty()) {
        EXPECT_EQ(innermost->kind->key(), "not");
        innermost = &innermost->children.front();
    }
    EXPECT_EQ(innermost->kind->key(), "on");
    EXPECT_EQ(innermost->path, "/goals" + repeated("/not", deepest));
}

TEST(GoalSize, GoalsThatNestTooDeepAreRefusedAtTheirPlace) {
    // Also a million of them unclosed: the message must not depend on the rest of the file.
    for (std::string const& goals :
         {nested(deepest + 1), nested(1'000'000), repeated(R"({"not": )", 1'000'000)}) {
        Verdict const read = outcomeOf(goals);
        ASSERT_EQ(read.problems.size(), 1U);
        EXPECT_EQ(read.problems[0].message, "nested too deeply");
        EXPECT_EQ(read.problems[0].path, "/goals" + repeated("/not", deepest + 1));
        EXPECT_EQ(read.problems[0].line, 1U);
        EXPECT_EQ(read.problems[0].column,
                  levelWithGoals("").size() + (deepest + 1) * std::string(R"({"not": )").size());
    }
    Verdict const lists = outcomeOf(repeated(R"({"all": [)", 1'000'000) + leaf + repeated("]}", 1'000'000));
    ASSERT_EQ(lists.problems.size(), 1U);
    EXPECT_EQ(lists.problems[0].message, "nested too deeply");
    EXPECT_EQ(lists.problems[0].path.substr(0, 13), "/goals/all/0/");
}

TEST(GoalSize, AsManyConditionsAsTheLimitAreRead) {
    for (char const* kind : {"all", "any", "sequence"}) {
        Verdict const read =
            outcomeOf(listOf(kind, limits::conditions - 1)); // the list itself counts as well
        ASSERT_TRUE(read.goals.has_value()) << read.problems.at(0).message;
        EXPECT_EQ(countOf(*read.goals), limits::conditions);
    }
    // Nested conditions count as well: 1 + 2 * (1 + 100 * 49) + (1 + 196).
    static_assert(limits::conditions == 10'000);
    std::string const most = listOf("any", 100, nested(48));
    Verdict const read = outcomeOf(R"({"all": [)" + most + ", " + most + ", " + listOf("any", 196) + "]}");
    ASSERT_TRUE(read.goals.has_value()) << read.problems.at(0).message;
    EXPECT_EQ(countOf(*read.goals), limits::conditions);
}

TEST(GoalSize, OneConditionTooManyIsRefusedAtItsPlace) {
    Verdict const list = outcomeOf(listOf("all", limits::conditions));
    ASSERT_EQ(list.problems.size(), 1U);
    EXPECT_EQ(list.problems[0].path, "/goals/all/9999");
    EXPECT_EQ(list.problems[0].message, "is one condition too many");
    EXPECT_EQ(list.problems[0].expected, "at most 10000");
    EXPECT_EQ(list.problems[0].column,
              levelWithGoals("").size() + std::string(R"({"all": [)").size() + 9999 * (leaf.size() + 2));
    // The last of many nested conditions: 5000 pairs and the list itself are one too many.
    Verdict const pairs = outcomeOf(listOf("any", limits::conditions / 2, nested(1)));
    ASSERT_EQ(pairs.problems.size(), 1U);
    EXPECT_EQ(pairs.problems[0].path, "/goals/any/4999/not");
}

TEST(GoalSize, TheMessageDoesNotDependOnTheExcess) {
    Verdict const wide = outcomeOf(listOf("all", 100'000));
    ASSERT_EQ(wide.problems.size(), 1U);
    EXPECT_EQ(wide.problems[0].path, "/goals/all");
    EXPECT_EQ(wide.problems[0].message, "has 100000 entries");
    // No single list of these is too long.
    Verdict const lists = outcomeOf(listOf("all", 20, listOf("any", limits::conditions - 1)));
    ASSERT_EQ(lists.problems.size(), 1U);
    EXPECT_EQ(lists.problems[0].path, "/goals/all/0/any/9998");
    EXPECT_EQ(lists.problems[0].message, "is one condition too many");
}

TEST(GoalSize, TheSchemaStatesTheSameLength) {
    nlohmann::json const schema = levelSchema(levelKit().registry);
    auto const faults = [&](std::size_t count) {
        return validate(schema, nlohmann::json::parse(levelWithGoals(listOf("sequence", count))));
    };
    EXPECT_TRUE(faults(limits::conditions).empty());
    EXPECT_FALSE(faults(limits::conditions + 1).empty());
}

} // namespace
} // namespace trembler
