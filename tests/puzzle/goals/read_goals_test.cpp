#include "puzzle/goals/read_goals.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

LevelFile levelWith(nlohmann::json goals) {
    LevelFile level;
    level.objects.resize(1);
    level.objects[0].name = "bell";
    level.goals = std::move(goals);
    return level;
}

TEST(ReadGoals, ReadsNothingInALevelWithoutGoals) {
    EXPECT_FALSE(readGoals(levelWith(nullptr)).has_value());
}

TEST(ReadGoals, ReadsLevelsThatWereNotReadFromFiles) {
    auto const goals = readGoals(levelWith({{"on", "bell"}, {"for", 2}, {"id", "light"}, {"text", "Ring"}}));
    ASSERT_TRUE(goals.has_value());
    EXPECT_EQ(goals->kind->key(), "on");
    EXPECT_EQ(goals->subject.names, std::vector<std::string>{"bell"});
    EXPECT_EQ(goals->seconds, 2);
    EXPECT_EQ(goals->id, "light");
    EXPECT_EQ(goals->text, "Ring");
    EXPECT_EQ(goals->path, "/goals");
}

TEST(ReadGoals, ReportsErrorsWithTheirPlaces) {
    try {
        (void)readGoals(levelWith(nlohmann::json::parse(R"({"all": [{"on": "bel"}]})")));
        FAIL();
    } catch (InputError const& error) {
        ASSERT_EQ(error.diagnostics().size(), 1U);
        EXPECT_EQ(error.diagnostics()[0].path, "/goals/all/0/on");
        EXPECT_EQ(error.diagnostics()[0].message, "there is no object 'bel' (did you mean 'bell'?)");
    }
    Problems problems;
    auto const none = readGoals(levelWith(nlohmann::json::object()), problems);
    EXPECT_THROW(problems.throwIfAny(), InputError);
    ASSERT_TRUE(none.has_value());
    EXPECT_EQ(none->kind, nullptr);
}

} // namespace
} // namespace trembler
