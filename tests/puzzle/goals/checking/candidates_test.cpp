#include "puzzle/goals/checking/candidates.hpp"
#include "tests/puzzle/goals/stage.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

LevelFile levelOf(std::vector<std::pair<std::string, std::string>> const& objects, // name, part
                  std::vector<std::pair<std::string, int>> const& toolbox) {
    LevelFile level;
    for (auto const& [name, part] : objects) {
        level.objects.emplace_back();
        level.objects.back().name = name;
        level.objects.back().part = part;
    }
    for (auto const& [part, count] : toolbox) {
        level.toolbox.push_back({part, count, ""});
    }
    return level;
}

Selector selectorOf(std::vector<std::string> names, std::vector<std::string> parts, bool it = false) {
    return {std::move(names), std::move(parts), it, ""};
}

TEST(Candidates, CountsExistingAndPlaceableObjectsOnce) {
    GoalStage stage(R"({"on": "lamp"})");
    LevelFile const level = levelOf({{"a", "ball"}, {"b", "ball"}, {"c", "box"}}, {{"ball", 3}, {"ball", 2}});
    CandidateFinder const finder(level, stage.world());
    EXPECT_EQ(finder.of(selectorOf({"a", "c", "a"}, {})).size(), 2U);
    EXPECT_EQ(finder.of(selectorOf({}, {"ball"})).size(), 2U + 5U);
    EXPECT_EQ(finder.of(selectorOf({"a"}, {"ball", "ball", "box"})).size(), 3U + 5U);
    EXPECT_EQ(finder.of(selectorOf({"a"}, {}, true)).size(), 2U);
    Candidates both = finder.of(selectorOf({"a"}, {"ball"}));
    finder.add(both, selectorOf({"c"}, {"ball"}));
    EXPECT_EQ(both.size(), 3U + 5U);
}

TEST(Candidates, AreFixedIfNoneOfThemCanMove) {
    GoalStage stage(R"({"on": "lamp"})");
    LevelFile const level =
        levelOf({{"floor", "wall"}, {"electromagnet", "coil"}, {"crate", "box"}}, {{"coil", 1}});
    CandidateFinder const finder(level, stage.world());
    EXPECT_TRUE(finder.areFixed(selectorOf({"floor", "electromagnet"}, {})));
    EXPECT_TRUE(finder.areFixed(selectorOf({}, {"wall"})));
    EXPECT_FALSE(finder.areFixed(selectorOf({"floor", "crate"}, {})));
    EXPECT_FALSE(finder.areFixed(selectorOf({}, {"coil"}))) << "a movable one may be placed";
    EXPECT_FALSE(finder.areFixed(selectorOf({"floor"}, {}, true))) << "\"it\" may be any object";
    EXPECT_FALSE(finder.areFixed(selectorOf({}, {"nothing"})));
}

} // namespace
} // namespace trembler
