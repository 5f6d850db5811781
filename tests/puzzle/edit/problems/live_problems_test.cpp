// Live problems: the same as verify's, with the object to select; and the problems that the file's checks do
// not find.
#include "puzzle/checks/level_checks.hpp"
#include "puzzle/edit/commands/arrange.hpp"
#include "puzzle/edit/commands/contents.hpp"
#include "puzzle/edit/commands/goals.hpp"
#include "puzzle/edit/commands/objects.hpp"
#include "puzzle/edit/problems/live_problems.hpp"
#include "puzzle/solutions/verify.hpp"
#include "tests/puzzle/edit/edit_kit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace trembler::edit {
namespace {

std::vector<Problem> problemsAfter(std::function<void(LevelDocument&)> const& change) {
    LevelDocument document = smallDocument();
    change(document);
    LiveProblems problems;
    EXPECT_TRUE(problems.refresh(document));
    EXPECT_FALSE(problems.refresh(document));
    return problems.all();
}

TEST(LiveProblems, FindNothingInLevelsThatAreRight) {
    for (auto const& path : editData().levels()) {
        LevelCheckup const checkup = checkWholeLevel(editData(), JsonDocument::load(path));
        EXPECT_TRUE(checkup.playable) << path;
        EXPECT_TRUE(checkup.problems.empty()) << path << ": " << checkup.problems.front().print();
    }
    EXPECT_TRUE(problemsAfter([](LevelDocument&) {}).empty());
}

TEST(LiveProblems, LeadToTheCulprit) {
    auto const removed = problemsAfter(
        [](LevelDocument& document) { document.run(removeObjects(editData(), document.tree(), {"ball"})); });
    ASSERT_FALSE(removed.empty());
    EXPECT_EQ(removed.front().about, Problem::About::solution);
    EXPECT_EQ(removed.front().name, "wait");
    auto const goal = problemsAfter([](LevelDocument& document) {
        document.run(
            changeGoal(document.tree(), "/all/1", Json{{"moved", {{"object", "table"}, {"by", 1}}}}));
    });
    ASSERT_EQ(goal.size(), 1U);
    EXPECT_EQ(goal.front().about, Problem::About::goal);
    EXPECT_EQ(goal.front().name, "/all/1");
    EXPECT_NE(goal.front().words().find("never"), std::string::npos);
    auto const part = problemsAfter(
        [](LevelDocument& document) { document.run(setPart(document.tree(), {"ball"}, "unheard")); });
    ASSERT_EQ(part.size(), 1U);
    EXPECT_EQ(part.front().name, "ball");
    EXPECT_EQ(part.front().index, 3U);
}

TEST(LiveProblems, FindWhatIsOutOfReach) {
    auto const away = problemsAfter([](LevelDocument& document) {
        document.run(moveObjects(editData(), document.tree(), {"ball"}, {50, 0}));
    });
    ASSERT_EQ(away.size(), 1U);
    EXPECT_EQ(away.front().name, "ball");
    EXPECT_EQ(away.front().inside, "/at");
    auto const area = problemsAfter([](LevelDocument& document) {
        document.run(setPlacingArea(document.tree(), 0, Area{Box{{60, 0}, {1, 1}}, {}}));
    });
    ASSERT_EQ(area.size(), 1U);
    EXPECT_EQ(area.front().about, Problem::About::placing);
    auto const goalArea = problemsAfter([](LevelDocument& document) {
        document.run(setGoalArea(document.tree(), "/all/1", Area{Box{{60, 0}, {1, 1}}, {}}));
    });
    ASSERT_EQ(goalArea.size(), 1U);
    EXPECT_EQ(goalArea.front().name, "/all/1");
    auto const full = problemsAfter([](LevelDocument& document) { // inside the table
        document.run(setPlacingArea(document.tree(), 0, Area{Box{{-1, -0.4}, {2, 0.2}}, {}}));
    });
    ASSERT_EQ(full.size(), 1U);
    EXPECT_EQ(full.front().about, Problem::About::tool);
    auto const none =
        problemsAfter([](LevelDocument& document) { document.run(removePlacingArea(document.tree(), 0)); });
    ASSERT_EQ(none.size(), 1U);
    EXPECT_EQ(none.front().about, Problem::About::placing);
}

TEST(LiveProblems, FindGoalsThatCanNeverComeTrue) {
    auto const after = [](Json const& goals, Json const& toolbox) {
        return problemsAfter([&](LevelDocument& document) {
            document.run(
                {"Goals", [&](Json& level) {
                     level["goals"] = goals;
                     level["toolbox"] = toolbox;
                     level["objects"].push_back({{"name", "lamp"}, {"part", "lamp"}, {"at", {3, 3}}});
                     level["objects"].push_back({{"name", "wall"}, {"part", "lamp"}, {"at", {4, 3}}});
                 }});
        });
    };
    Json const none = Json::array();
    auto const dark = after({{"all", {{{"on", "lamp"}}, {{"touching", {"ball", "table"}}}}}}, none);
    ASSERT_EQ(dark.size(), 1U);
    EXPECT_EQ(dark.front().name, "/all/0");
    EXPECT_NE(dark.front().words().find("no source"), std::string::npos);
    EXPECT_TRUE(after({{"on", "lamp"}}, {{{"part", "battery"}, {"count", 1}}}).empty())
        << "the player may bring a source";
    ASSERT_EQ(after({{"touching", {"lamp", "wall"}}}, none).size(), 1U) << "both are fixed";
    EXPECT_TRUE(after({{"touching", {"lamp", "ball"}}}, none).empty());
    Json const touches{{"touching", {"ball", "table"}}};
    auto const opposed = after({{"all", {touches, {{"not", touches}}}}}, none);
    ASSERT_EQ(opposed.size(), 1U);
    EXPECT_EQ(opposed.front().name, "/all/1");
    EXPECT_TRUE(after({{"any", {touches, {{"not", touches}}}}}, none).empty());
}

TEST(LiveProblems, FindTasksThatCanNeverComeTrue) {
    auto const after = [](Json const& task) {
        return problemsAfter([&](LevelDocument& document) {
            document.run(
                {"Task", [&](Json& level) {
                     level["demonstration"] = true;
                     level["task"] = task;
                     level["objects"].push_back({{"name", "lamp"}, {"part", "lamp"}, {"at", {3, 3}}});
                 }});
        });
    };
    Json const touches{{"touching", {"ball", "table"}}};
    EXPECT_TRUE(after(touches).empty());
    struct Case {
        Json task;
        char const* place;
        char const* words;
    };
    for (Case const& tried :
         {Case{{{"on", "lamp"}}, "", "no source"},
          Case{{{"all", {touches, {{"not", touches}}}}}, "/all/1", "opposite"},
          Case{{{"all", {touches, {{"moved", {{"object", "table"}, {"by", 1}}}}}}}, "/all/1", "never"},
          Case{{{"inside", {{"object", "ball"}, {"area", {60, 0, 1, 1}}}}}, "", "outside the bounds"},
          Case{{{"all", {touches, {{"on", "lmap"}}}}}, "/all/1", "'lmap'"}}) {
        auto const found = after(tried.task);
        ASSERT_EQ(found.size(), 1U) << tried.task;
        EXPECT_EQ(found.front().about, Problem::About::task) << tried.task;
        EXPECT_EQ(found.front().name, tried.place) << tried.task;
        EXPECT_NE(found.front().words().find(tried.words), std::string::npos) << found.front().words();
        EXPECT_GT(found.front().diagnostic.line, 0U);
    }
}

TEST(LiveProblems, ListWhatALevelLacks) {
    auto const without = [](char const* key) {
        return problemsAfter([&](LevelDocument& document) {
            document.run({"Remove", [&](Json& level) { level.erase(key); }});
        });
    };
    auto const goals = without("goals");
    ASSERT_EQ(goals.size(), 1U);
    EXPECT_EQ(goals.front().about, Problem::About::goal);
    EXPECT_EQ(goals.front().words(), "it has no goals");
    auto const solutions = without("solutions");
    ASSERT_EQ(solutions.size(), 1U);
    EXPECT_EQ(solutions.front().about, Problem::About::solution);
    EXPECT_EQ(solutions.front().words(), "no solution is recorded");
    // Problems do not keep a designer from playing the level.
    LiveProblems problems;
    problems.refresh(LevelDocument::blank(editData()));
    EXPECT_EQ(problems.all().size(), 2U);
    EXPECT_TRUE(problems.playable());
}

TEST(LiveProblems, ListFaultyPartsOfTheAuthor) {
    auto const folder = testFolder();
    std::filesystem::create_directories(folder / "trembler" / "parts");
    writeText(folder / "trembler" / "parts" / "broken.json",
              R"({"name": "broken", "properties": {"mass": "heavy"}})");
    char const* const before = std::getenv("XDG_DATA_HOME");
    std::string const kept = before == nullptr ? "" : before;
    ::setenv("XDG_DATA_HOME", folder.c_str(), 1);
    GameData const data;
    if (before == nullptr) {
        ::unsetenv("XDG_DATA_HOME");
    } else {
        ::setenv("XDG_DATA_HOME", kept.c_str(), 1);
    }
    LevelDocument const document = LevelDocument::fromText(data, smallLevel(), {}, {});
    LiveProblems problems;
    problems.refresh(document);
    ASSERT_EQ(problems.all().size(), 1U);
    EXPECT_EQ(problems.all().front().about, Problem::About::ownPart);
    EXPECT_EQ(problems.all().front().name, "broken.json");
    EXPECT_TRUE(problems.playable());
}

TEST(LiveProblems, AreThoseOfVerify) {
    auto const file = testFolder() / "level.json";
    writeText(file, smallLevel());
    LevelDocument document = LevelDocument::open(editData(), file);
    document.run(moveObjects(editData(), document.tree(), {"ball"}, {50, 0}));
    ASSERT_TRUE(document.save().ok());
    LiveProblems problems;
    problems.refresh(document);
    auto const failures = verifyLevel(editData(), file);
    for (Problem const& problem : problems.all()) {
        EXPECT_NE(std::find(failures.begin(), failures.end(), problem.diagnostic.print()), failures.end());
    }
    EXPECT_FALSE(problems.empty());
}

TEST(LiveProblems, OfAReadOnlyFileAreItsFaults) {
    auto const file = testFolder() / "level.json";
    writeText(file, "{");
    LiveProblems problems;
    problems.refresh(LevelDocument::open(editData(), file));
    EXPECT_EQ(problems.all().size(), 1U);
    EXPECT_FALSE(problems.playable());
}

} // namespace
} // namespace trembler::edit
