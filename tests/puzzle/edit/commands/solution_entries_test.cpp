// Single entries of recorded solutions: added, changed, removed, ordered; the names of placed objects follow.
#include "puzzle/edit/commands/solutions.hpp"
#include "puzzle/edit/problems/live_problems.hpp"
#include "tests/puzzle/edit/edit_kit.hpp"

#include <gtest/gtest.h>

namespace trembler::edit {
namespace {

Json withTwoBalls() {
    Json level = Json::parse(smallLevel());
    level["solutions"][0]["placements"] = Json::array(
        {Json{{"part", "steel ball"}, {"at", {0, 2}}}, Json{{"part", "steel ball"}, {"at", {1, 2}}}});
    level["solutions"][0]["wires"] = Json::array({Json::array({"steel ball 1", "left"})});
    level["solutions"][0]["inputs"] =
        Json::array({Json{{"frame", 5}, {"grab", "steel ball 2"}, {"at", {1, 2}}},
                     Json{{"frame", 9}, {"release", true}}});
    return level;
}

Json changedBy(Json tree, Command const& command) {
    command.change(tree);
    return tree;
}

TEST(SolutionEntries, AreAddedChangedAndRemoved) {
    Json const level = Json::parse(smallLevel());
    Json const placed = changedBy(
        level, addSolutionEntry(level, "wait", "placements", Json{{"part", "steel ball"}, {"at", {1, 2}}}));
    Json const& solution = placed["solutions"][0];
    EXPECT_EQ(solution["placements"].size(), 1U);
    EXPECT_EQ(solution.begin().key(), "name");
    EXPECT_EQ(std::next(solution.begin()).key(), "placements") << "at its usual place";
    EXPECT_EQ(placedNames(placed, "wait"), std::vector<std::string>{"steel ball 1"});
    Json const turned =
        changedBy(placed, setSolutionEntry(placed, "wait", "placements", 0,
                                           Json{{"part", "steel ball"}, {"at", {1, 2}}, {"angle_deg", 5}}));
    EXPECT_EQ(turned["solutions"][0]["placements"][0]["angle_deg"], 5);
    EXPECT_EQ(changedBy(placed, removeSolutionEntry(placed, "wait", "placements", 0)), level);
    Json const ordered = changedBy(level, moveSolutionEntry(level, "wait", "inputs", 1, 0));
    EXPECT_EQ(ordered["solutions"][0]["inputs"][0]["release"], true);
    for (auto const& refused :
         {refusalOf([&] { return addSolutionEntry(level, "none", "inputs", Json::object()); }),
          refusalOf([&] { return addSolutionEntry(level, "wait", "name", Json::object()); }),
          refusalOf([&] { return addSolutionEntry(level, "wait", "inputs", 3); }),
          refusalOf([&] { return removeSolutionEntry(level, "wait", "inputs", 2); }),
          refusalOf([&] { return setSolutionEntry(level, "wait", "wires", 0, Json::object()); })}) {
        EXPECT_NE(refused, "");
    }
}

TEST(SolutionEntries, FollowTheNamesOfPlacedObjects) {
    Json const level = withTwoBalls();
    EXPECT_EQ(placedNames(level, "wait"), (std::vector<std::string>{"steel ball 1", "steel ball 2"}));
    // The first ball is moved to the right of the other one, and so becomes the second.
    Json const moved = changedBy(level, setSolutionEntry(level, "wait", "placements", 0,
                                                         Json{{"part", "steel ball"}, {"at", {3, 2}}}));
    EXPECT_EQ(placedNames(moved, "wait"), (std::vector<std::string>{"steel ball 2", "steel ball 1"}));
    EXPECT_EQ(moved["solutions"][0]["wires"], Json::array({Json::array({"steel ball 2", "left"})}));
    EXPECT_EQ(moved["solutions"][0]["inputs"][0]["grab"], "steel ball 1");
    // The wire of a ball that is removed goes with it; the other ball is the only one now.
    Json const one = changedBy(level, removeSolutionEntry(level, "wait", "placements", 0));
    EXPECT_FALSE(one["solutions"][0].contains("wires"));
    EXPECT_EQ(one["solutions"][0]["inputs"][0]["grab"], "steel ball 1");
    EXPECT_EQ(one["solutions"][0]["inputs"].size(), 2U);
}

TEST(SolutionEntries, AreCheckedByTheListOfProblems) {
    LevelDocument document = smallDocument();
    LiveProblems problems;
    static_cast<void>(problems.refresh(document));
    std::size_t const before = problems.all().size();
    document.run(
        addSolutionEntry(document.tree(), "wait", "inputs", Json{{"frame", 5}, {"remove", "nothing"}}));
    static_cast<void>(problems.refresh(document));
    ASSERT_GT(problems.all().size(), before);
    EXPECT_EQ(problems.all().back().about, Problem::About::solution);
    document.undo();
    static_cast<void>(problems.refresh(document));
    EXPECT_EQ(problems.all().size(), before);
}

} // namespace
} // namespace trembler::edit
