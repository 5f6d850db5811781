// The entries of a recorded solution: changed, added and removed by their forms, undone, and checked at once.
#include "tests/game/ui/edit/editor_kit.hpp"

namespace trembler::ui::test {
namespace solution_entries_test {
namespace {

char const* const recorded = R"({"version": 2, "title": "Recorded",
    "world": {"gravity": [0, -9.81], "bounds": [-4, -0.5, 8, 4.5]},
    "objects": [
        {"name": "floor", "at": [0, -0.15], "properties": {"material": "stone", "fixed": true,
         "shape": [{"form": "box", "width": 7.6, "height": 0.3}]}},
        {"name": "ball", "part": "steel ball", "at": [2, 0.1]}],
    "toolbox": [{"part": "plank", "count": 2}],
    "goals": {"touching": ["ball", "floor"]},
    "solutions": [{"name": "wait", "placements": [{"part": "plank", "at": [0, 1]}],
                   "inputs": [{"frame": 3, "grab": "ball", "at": [2, 0.1]}, {"frame": 9, "release": true}]}]})";

edit::Json const& solution(Designer& designer) {
    return designer.tree()["solutions"][0];
}

void showEntries(Designer& designer) {
    designer.key(SDLK_F7);
    designer.frames(2);
    designer.clickItem("solution 0 entries");
    designer.frames(2);
}

TEST(SolutionEntryRows, ChangeAddAndRemoveWithUndo) {
    Designer designer({1280, 1600});
    designer.editText(recorded);
    std::string const before = designer.parts().document.text();
    showEntries(designer);
    designer.look("edit-solution-entries");
    designer.drag(designer.item("placements 0/at x"), designer.item("placements 0/at x") + Point{60, 0});
    double const x = solution(designer)["placements"][0]["at"][0].get<double>();
    EXPECT_GT(x, 0.1);
    EXPECT_EQ(designer.parts().document.done(), 1U) << "a drag is one step";
    designer.clickItem("placements 0/flipped");
    EXPECT_EQ(solution(designer)["placements"][0]["flipped"], true);
    designer.drag(designer.item("placements 0/angle_deg"),
                  designer.item("placements 0/angle_deg") + Point{60, 0});
    EXPECT_GT(solution(designer)["placements"][0]["angle_deg"].get<double>(), 0);
    designer.clickItem("add inputs");
    designer.frames(1);
    designer.clickItem("add inputs = remove");
    designer.frames(2);
    ASSERT_EQ(solution(designer)["inputs"].size(), 3U);
    EXPECT_EQ(solution(designer)["inputs"][2]["remove"], "floor");
    designer.clickItem("inputs 2/remove");
    designer.frames(1);
    designer.clickItem("inputs 2/remove = plank 1");
    designer.frames(2);
    EXPECT_EQ(solution(designer)["inputs"][2]["remove"], "plank 1") << "a placed part can be named";
    designer.clickItem("inputs 0 remove");
    designer.frames(2);
    EXPECT_EQ(solution(designer)["inputs"][0]["release"], true);
    designer.clickItem("add placements");
    designer.frames(2);
    ASSERT_EQ(solution(designer)["placements"].size(), 2U);
    EXPECT_EQ(solution(designer)["placements"][1]["part"], "plank");
    std::size_t const steps = designer.parts().document.done();
    EXPECT_EQ(steps, 7U);
    std::string const after = designer.parts().document.text();
    for (std::size_t i = 0; i < steps; ++i) {
        designer.ctrl(SDLK_z);
    }
    EXPECT_EQ(designer.parts().document.text(), before);
    for (std::size_t i = 0; i < steps; ++i) {
        designer.ctrl(SDLK_y);
    }
    EXPECT_EQ(designer.parts().document.text(), after);
    designer.look("edit-solution-entries-changed");
}

TEST(SolutionEntryRows, AreCheckedWhileTheyAreChanged) {
    Designer designer({1280, 1600});
    designer.editText(recorded);
    designer.frames(60);
    std::size_t const before = designer.parts().problems.all().size();
    showEntries(designer);
    for (int i = 0; i < 2; ++i) { // one more than the toolbox has
        designer.clickItem("add placements");
        designer.frames(2);
    }
    ASSERT_EQ(solution(designer)["placements"].size(), 3U);
    designer.frames(90);
    EXPECT_GT(designer.parts().problems.all().size(), before);
    designer.ctrl(SDLK_z);
    designer.ctrl(SDLK_z);
    designer.frames(90);
    EXPECT_EQ(designer.parts().problems.all().size(), before);
}

TEST(SolutionEntryRows, OfALongRecordingAreShownByTheDozen) {
    Designer designer({1280, 1600});
    edit::Json level = edit::Json::parse(recorded);
    for (int i = 0; i < 40; ++i) {
        level["solutions"][0]["inputs"].push_back(edit::Json{{"frame", 10 + i}, {"move", {0, 1}}});
    }
    designer.editText(level.dump());
    showEntries(designer);
    EXPECT_TRUE(designer.shows("inputs 0/frame"));
    EXPECT_FALSE(designer.shows("inputs 20/frame"));
    designer.drag(designer.item("inputs from"), designer.item("inputs from") + Point{420, 0});
    designer.frames(2);
    EXPECT_FALSE(designer.shows("inputs 0/frame"));
    designer.seek("add inputs");
    designer.clickItem("add inputs");
    designer.frames(1);
    designer.clickItem("add inputs = release");
    designer.frames(2);
    ASSERT_EQ(solution(designer)["inputs"].size(), 43U);
    designer.seek("inputs 42/frame"); // the new one
}

} // namespace
} // namespace solution_entries_test
} // namespace trembler::ui::test
