// The level's words in other languages, and the task of a demonstration, in the editor's panel; with real
// events of the mouse and the keyboard.
#include "tests/game/ui/edit/editor_kit.hpp"

namespace trembler::ui::test {
namespace translation_rows_test {
namespace {

auto const bell = levelsFolder() / "experiments/2-doorbell.json";

/// Opens the level's page and scrolls down to an item.
void scrollToItem(Designer& designer, std::string const& item) {
    designer.key(SDLK_F6);
    designer.frames(2);
    designer.scrollTo("panel", item);
    designer.wheel(-1); // it may be cut off by the edge
    designer.frames(2);
    ASSERT_TRUE(designer.shows(item)) << item;
}

/// Replaces the content of a field.
void typeInto(Designer& designer, std::string const& item, std::string const& text) {
    designer.clickItem(item);
    designer.frames(1);
    designer.ctrl(SDLK_a);
    designer.typeText(text);
    designer.frames(1);
    designer.click(designer.on(designer.parts().middleOfView())); // leaves the field
    designer.frames(2);
}

TEST(TranslationRows, MakeAndChangeTheWordsOfALanguage) {
    Designer designer;
    designer.editNew();
    scrollToItem(designer, "add language");
    designer.clickItem("add language");
    designer.typeText("de");
    designer.key(SDLK_RETURN);
    designer.frames(3);
    ASSERT_TRUE(designer.tree().contains("texts"));
    EXPECT_EQ(designer.tree()["texts"].dump(), R"({"de":{}})");
    scrollToItem(designer, "translated title missing");
    typeInto(designer, "translated title de", "Neues Level");
    EXPECT_EQ(designer.tree()["texts"]["de"]["title"], "Neues Level");
    EXPECT_FALSE(designer.shows("translated title missing"));
    designer.look("edit-translations");
    designer.ctrl(SDLK_z);
    designer.frames(2);
    EXPECT_EQ(designer.tree()["texts"].dump(), R"({"de":{}})");
    designer.ctrl(SDLK_z);
    designer.frames(2);
    EXPECT_FALSE(designer.tree().contains("texts"));
}

TEST(GoalsPage, ChangesTheTaskOfADemonstration) {
    Designer designer;
    designer.editCopyOf(bell);
    edit::Json const goals = designer.tree()["goals"];
    edit::Json const task = designer.tree()["task"];
    designer.key(SDLK_F5);
    designer.frames(2);
    ASSERT_TRUE(designer.shows("tree task"));
    designer.clickItem("tree task");
    designer.frames(2);
    designer.clickItem("goal /sequence/3");
    designer.frames(2);
    designer.look("edit-task");
    designer.scrollTo("panel", "goal up");
    designer.clickItem("goal up");
    designer.frames(2);
    EXPECT_EQ(designer.tree()["goals"], goals);
    EXPECT_EQ(designer.tree()["task"]["sequence"][2], task["sequence"][3]);
    designer.ctrl(SDLK_z);
    designer.frames(2);
    EXPECT_EQ(designer.tree()["task"], task);
    // In the test play, as for a player, the goals are those of the task.
    designer.key(SDLK_SPACE);
    designer.frames(4);
    ASSERT_NE(designer.screen().test(), nullptr);
    EXPECT_EQ(edit::Json(designer.screen().test()->session().level().goals)["id"], "silenced");
    designer.key(SDLK_ESCAPE);
    designer.frames(2);
    designer.editNew();
    designer.key(SDLK_F5);
    designer.frames(2);
    EXPECT_FALSE(designer.shows("tree task")) << "only demonstrations have one";
}

} // namespace
} // namespace translation_rows_test
} // namespace trembler::ui::test
