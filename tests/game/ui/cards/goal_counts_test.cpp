// Goals that count show the number reached so far.
#include "game/ui/cards/goal_counts.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/game/ui/player.hpp"

namespace trembler::ui::test {
namespace goal_counts_test {
namespace {

std::vector<int> countsWith(char const* goals) {
    LevelFile level = loadLevel(gameData().registry, levelsFolder() / "first/1-first-contact.json");
    level.goals = nlohmann::json::parse(goals);
    return goalCounts(level);
}

TEST(GoalCounts, AreThoseOfTheLevel) {
    constexpr char const* touch = R"({"touching": ["iron ball", "electromagnet"]})";
    std::string const one = touch;
    EXPECT_EQ(countsWith(touch), std::vector<int>{0});
    EXPECT_EQ(countsWith((R"({"all": [{"on": "electromagnet"}, )" + one + "]}").c_str()),
              (std::vector<int>{0, 0}));
    EXPECT_EQ(countsWith(
                  (R"({"all": [{"sequence": [)" + one + "," + one + "," + one + "]}, " + one + "]}").c_str()),
              (std::vector<int>{3, 0}));
    EXPECT_EQ(countsWith((R"({"sequence": [)" + one + "," + one + R"(], "text": "Ring twice"})").c_str()),
              std::vector<int>{2})
        << "it is one goal, because it has a text of its own";
}

TEST(GoalCounts, ReachedOnesFollowTheProgress) {
    GoalStatus goal;
    EXPECT_EQ(reachedOf(goal, 3), 0);
    goal.progress = 1.0 / 3;
    EXPECT_EQ(reachedOf(goal, 3), 1);
    goal.progress = 0.5;
    EXPECT_EQ(reachedOf(goal, 3), 1);
    goal = {};
    goal.met = true;
    EXPECT_EQ(reachedOf(goal, 3), 3);
}

} // namespace
} // namespace goal_counts_test
} // namespace trembler::ui::test
