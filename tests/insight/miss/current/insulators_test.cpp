// Wood across a gap: the answer says that it does not conduct.
#include "insight/miss/current/insulators.hpp"
#include "insight/why/words/words.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/insight/support/explained_miss.hpp"
#include "tests/support/game_data.hpp"

#include <gtest/gtest.h>

namespace trembler::insight {
namespace insulators_test {
namespace {

TEST(Insulators, AreNamedWhereTheyLayAcrossAGap) {
    LevelFile const level = loadLevel(gameData().registry, testedFile("first/1-first-contact.json"));
    Solution const& wood = *level.findSolution("the wooden bar");
    Miss const miss = explainedMiss(level, 120, {wood});
    ASSERT_EQ(miss.gaps.size(), 1U);
    EXPECT_EQ(miss.gaps.front().nameBy, "wooden bar 1");
    std::string const said = sentencesOf(miss, AnswerLanguage()).front();
    EXPECT_NE(said.find("wooden bar 1 across it does not conduct"), std::string::npos) << said;
    Miss const nothing = explainedMiss(level, 120);
    ASSERT_EQ(nothing.gaps.size(), 1U);
    EXPECT_EQ(nothing.gaps.front().nameBy, "") << "nothing lies there";
}

} // namespace
} // namespace insulators_test
} // namespace trembler::insight
