// A designer's work from opening a level to testing it, with real input events.
#include "tests/game/ui/edit/editor_kit.hpp"

namespace trembler::ui::test {
namespace edit_screen_test {
namespace {

auto const firstContact = levelsFolder() / "first/1-first-contact.json";
Vec2 const ball{1.7, 0.15};

TEST(Editor, OpensSelectsMovesUndoesSavesAndTests) {
    Designer designer;
    designer.drawEveryPicture();
    auto const file = designer.editCopyOf(firstContact);
    std::string const before = textOfFile(file);
    designer.select(ball);
    ASSERT_EQ(designer.parts().selected(), std::vector<std::string>{"iron ball"});
    designer.drag(designer.on(ball), designer.on({1.2, 0.15}));
    EXPECT_NEAR(designer.placeOf("iron ball").x, 1.2, 1e-9);
    EXPECT_TRUE(designer.parts().document.modified());
    designer.ctrl(SDLK_z);
    EXPECT_EQ(designer.placeOf("iron ball"), ball);
    EXPECT_FALSE(designer.parts().document.modified());
    designer.ctrl(SDLK_y);
    EXPECT_NEAR(designer.placeOf("iron ball").x, 1.2, 1e-9);
    designer.look("edit-first");
    designer.ctrl(SDLK_s);
    EXPECT_FALSE(designer.parts().document.modified());
    std::string const after = textOfFile(file);
    EXPECT_NE(after, before);
    EXPECT_NE(after.find("[1.2, 0.15]"), std::string::npos);
    designer.key(SDLK_SPACE);
    ASSERT_NE(designer.screen().test(), nullptr);
    designer.frames(2);
    EXPECT_TRUE(designer.showsCard("goal"));
    designer.look("edit-test");
    designer.key(SDLK_ESCAPE);
    EXPECT_EQ(designer.screen().test(), nullptr);
    EXPECT_FALSE(designer.app().menu().isOpen());
    EXPECT_TRUE(designer.parts().document.canUndo()) << "nothing is lost by testing";
}

TEST(Editor, OpensFromTheTitleScreen) {
    Designer designer;
    designer.clickItem("editor");
    designer.frames(3);
    EXPECT_GT(designer.count("objects"), 0U);
    designer.look("edit-new");
}

TEST(Editor, DrawsShapesAndTurnsThem) {
    Designer designer;
    designer.editNew();
    std::size_t const before = designer.count("objects");
    designer.key(SDLK_2);
    designer.drag(designer.on({-1, 1}), designer.on({-0.5, 1.3}));
    designer.key(SDLK_3);
    designer.drag(designer.on({0, 1}), designer.on({0.25, 1}));
    designer.key(SDLK_4);
    designer.drag(designer.on({-1, 2}), designer.on({0, 2}));
    designer.key(SDLK_5);
    for (Vec2 const corner : {Vec2{0.5, 2}, Vec2{1, 2}, Vec2{0.75, 2.5}, Vec2{0.5, 2}}) {
        designer.click(designer.on(corner));
    }
    EXPECT_EQ(designer.count("objects"), before + 4);
    designer.look("edit-shapes");
    EXPECT_EQ(designer.parts().selected().size(), 1U);
    designer.key(SDLK_q);
    auto const& last = designer.tree()["objects"].back();
    EXPECT_NEAR(last["angle_deg"].get<double>(), 15, 1e-9);
    for (int i = 0; i < 5; ++i) {
        designer.ctrl(SDLK_z);
    }
    EXPECT_EQ(designer.count("objects"), before);
}

TEST(Editor, SelectsWithABoxAndDeletesAndPastes) {
    Designer designer;
    designer.editCopyOf(firstContact);
    std::size_t const before = designer.count("objects");
    designer.drag(designer.on({-2.65, 1.25}), designer.on({-0.9, -0.1}));
    EXPECT_EQ(designer.parts().selected().size(), 4U);
    designer.ctrl(SDLK_c);
    designer.key(SDLK_DELETE);
    EXPECT_EQ(designer.count("objects"), before - 4);
    designer.ctrl(SDLK_v);
    EXPECT_EQ(designer.count("objects"), before);
    designer.ctrl(SDLK_d);
    EXPECT_EQ(designer.count("objects"), before + 4);
    designer.ctrl(SDLK_a);
    EXPECT_EQ(designer.parts().selected().size(), designer.count("objects"));
}

TEST(Editor, JoinsAndConnectsByDragging) {
    Designer designer;
    designer.editCopyOf(firstContact);
    std::size_t const connections = designer.count("connections");
    designer.key(SDLK_7);
    designer.drag(designer.on({-2.3, 0.875}), designer.on({-1.3, 0.875}));
    EXPECT_EQ(designer.count("connections"), connections + 1);
    designer.key(SDLK_6);
    designer.drag(designer.on({1.7, 3.1}), designer.on(ball));
    ASSERT_EQ(designer.count("joints"), 1U);
    EXPECT_EQ(designer.tree()["joints"][0]["a"], "beam");
    EXPECT_EQ(designer.tree()["joints"][0]["b"], "iron ball");
    EXPECT_EQ(designer.parts().selection.kind(), EntryKind::joint);
    designer.look("edit-joint");
    designer.key(SDLK_DELETE);
    EXPECT_EQ(designer.count("joints"), 0U);
}

TEST(Editor, PlacesPartsOfTheCatalogueAndDrawsAreas) {
    Designer designer;
    designer.editCopyOf(firstContact);
    std::size_t const before = designer.count("objects");
    designer.key(SDLK_F2);
    designer.drag(designer.item("part bell"), designer.on({0, 2}));
    EXPECT_EQ(designer.count("objects"), before + 1);
    std::size_t const areas = designer.count("placing");
    designer.key(SDLK_8);
    designer.drag(designer.on({0.2, 0.5}), designer.on({1, 1}));
    EXPECT_EQ(designer.count("placing"), areas + 1);
    designer.key(SDLK_ESCAPE); // the tool stays until then
    designer.drag(designer.on({1, 1}), designer.on({1.2, 1.3}));
    auto const area = designer.tree()["placing"].back();
    EXPECT_NEAR(area[2].get<double>(), 1.0, 1e-9);
    EXPECT_NEAR(area[3].get<double>(), 0.8, 1e-9);
    designer.look("edit-areas");
}

TEST(Editor, DrawsAreasOfManyCorners) {
    Designer designer;
    designer.editCopyOf(firstContact);
    std::size_t const areas = designer.count("placing");
    designer.key(SDLK_8);
    for (Vec2 const corner : {Vec2{0.2, 0.6}, Vec2{1, 0.6}, Vec2{0.6, 1.2}, Vec2{0.2, 0.6}}) {
        designer.click(designer.on(corner));
    }
    ASSERT_EQ(designer.count("placing"), areas + 1);
    EXPECT_EQ(designer.tree()["placing"].back().size(), 3U);
    EXPECT_EQ(designer.parts().tool, Tool::placing) << "for the next area";
}

TEST(Editor, GoesOnAfterSaving) {
    Designer designer;
    auto const file = designer.editCopyOf(firstContact);
    designer.select(ball);
    designer.key(SDLK_LEFT);
    designer.ctrl(SDLK_n);
    designer.frames(2);
    ASSERT_TRUE(designer.showsCard("unsaved"));
    designer.clickItem("save and go");
    designer.frames(2);
    EXPECT_TRUE(designer.parts().document.path().empty()) << "a new level";
    EXPECT_NE(textOfFile(file), textOfFile(firstContact));
}

TEST(Editor, RecordsASolutionByPlaying) {
    Designer designer;
    designer.editCopyOf(firstContact);
    std::size_t const before = designer.count("solutions");
    designer.key(SDLK_SPACE);
    ASSERT_NE(designer.screen().test(), nullptr);
    designer.frames(2);
    auto& play = *designer.screen().test();
    Point const to = play.camera().toScreen({-1.8, 1.2});
    designer.drag(designer.item("part steel bar"), to);
    ASSERT_EQ(play.session().placed().size(), 1U);
    designer.key(SDLK_SPACE);
    designer.simulate(600);
    EXPECT_TRUE(play.session().solved());
    designer.look("edit-record");
    designer.clickItem("record solution");
    EXPECT_EQ(designer.count("solutions"), before + 1);
    designer.clickItem("back to editor");
    EXPECT_EQ(designer.screen().test(), nullptr);
    designer.look("edit-solutions");
}

TEST(Editor, TheLevelIsNeverLeftFarBehind) {
    Designer designer;
    designer.editText(R"({"version": 2, "title": "Room",
        "world": {"gravity": [0, -9.81], "bounds": [-4, -0.5, 8, 4.5]},
        "objects": [{"name": "crate", "part": "crate", "at": [-1, 1]}]})");
    auto const pan = [&](Point by) {
        for (int i = 0; i < 30; ++i) {
            designer.drag({500, 360}, Point{500, 360} + by, MouseButton::Right, 1);
        }
    };
    pan({-400, 0});
    double const right = designer.parts().camera().centre.x;
    EXPECT_GT(right, 8) << "there is room beside the level to draw in";
    EXPECT_LT(right, 24) << "two windows beyond its edge";
    pan({0, 300});
    EXPECT_GT(designer.parts().camera().centre.y, -0.5 - 20);
    pan({400, 0});
    EXPECT_LT(designer.parts().camera().centre.x, -8);
    EXPECT_GT(designer.parts().camera().centre.x, -24);
}

TEST(Editor, AsksBeforeChangesAreLost) {
    Designer designer;
    designer.editCopyOf(firstContact);
    designer.select(ball);
    designer.key(SDLK_LEFT);
    designer.key(SDLK_ESCAPE); // deselects
    designer.key(SDLK_ESCAPE);
    ASSERT_TRUE(designer.app().menu().isOpen());
    designer.frames(2);
    designer.clickItem("menu.title");
    designer.frames(2);
    EXPECT_TRUE(designer.showsCard("unsaved"));
    designer.look("edit-unsaved");
    designer.clickItem("stay");
    designer.frames(2);
    EXPECT_FALSE(designer.showsCard("unsaved"));
    EXPECT_NE(dynamic_cast<EditScreen*>(&designer.app().screen()), nullptr);
    render::pushQuit();
    designer.frames(3);
    EXPECT_TRUE(designer.going());
    designer.clickItem("drop changes");
    designer.frames(2);
    EXPECT_FALSE(designer.going());
}

} // namespace
} // namespace edit_screen_test
} // namespace trembler::ui::test
