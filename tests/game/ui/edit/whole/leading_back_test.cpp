// What leads back to the editor says so.
#include "tests/game/ui/drawn_words.hpp"
#include "tests/game/ui/edit/editor_kit.hpp"

#include <algorithm>

namespace trembler::ui::test {
namespace leading_back_test {
namespace {

auto const level = levelsFolder() / "first/1-first-contact.json";

// "Next level" led back to the editor, and "Paused" headed its menu.
TEST(LeadingBack, TheTestAndTheMenuSayWhereTheyLead) {
    Designer designer;
    designer.editCopyOf(level);
    designer.key(SDLK_F10);
    designer.frames(3);
    ASSERT_TRUE(designer.showsCard("menu"));
    designer.look("edit-menu");
    auto const ofMenu = DrawnWords().lines();
    EXPECT_EQ(std::count(ofMenu.begin(), ofMenu.end(), "Paused"), 0);
    EXPECT_EQ(std::count(ofMenu.begin(), ofMenu.end(), "Menu"), 1);
    designer.clickItem("menu.edit_on");
    designer.frames(2);
    designer.screen().commands().run("edit-test");
    designer.frames(4);
    PlayScreen* const test = designer.screen().test();
    ASSERT_NE(test, nullptr);
    ASSERT_TRUE(test->session().place({"steel bar", {-1.8, 1.3}, 0, ""}));
    designer.key(SDLK_SPACE);
    designer.simulate(400);
    designer.frames(4);
    ASSERT_TRUE(designer.showsCard("success"));
    designer.look("edit-test-success");
    auto const ofSuccess = DrawnWords().lines();
    EXPECT_EQ(std::count(ofSuccess.begin(), ofSuccess.end(), "Next level"), 0);
    designer.clickItem("next level");
    designer.frames(2);
    EXPECT_EQ(designer.screen().test(), nullptr) << "back in the editor";
}

// `edit NEW.json` was headed "new level".
TEST(LeadingBack, ANewFileHeadsTheEditorBeforeItIsSaved) {
    Designer designer;
    auto const file = testFolder() / "seesaw.json";
    std::filesystem::remove(file);
    designer.app().edit(file);
    designer.frames(4);
    designer.look("edit-new-file");
    auto const lines = DrawnWords().lines();
    EXPECT_EQ(std::count(lines.begin(), lines.end(), "seesaw.json"), 1);
}

} // namespace
} // namespace leading_back_test
} // namespace trembler::ui::test
