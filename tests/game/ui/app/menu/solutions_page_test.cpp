// Saved solutions are loaded, renamed and deleted in the game.
#include "game/ui/app/command_lists.hpp"
#include "game/ui/app/menu/solutions_page.hpp"
#include "game/ui/shared/texts.hpp"
#include "tests/game/ui/player.hpp"
#include "tests/game/ui/tidy.hpp"

#include <algorithm>

namespace trembler::ui::test {
namespace solutions_page_test {
namespace {

auto const contactLevel = levelsFolder() / "first/1-first-contact.json";
std::string const contactId = "first/1-first-contact.json";

class SolutionsList : public testing::Test {
protected:
    SolutionsList() {
        std::filesystem::remove_all(player.films());
        player.open(contactLevel);
    }
    std::vector<SavedSolution> saved() { return player.app().context().solutions.of(contactId); }
    /// Solves the level with a part and saves the run.
    void solveAndSave(std::string const& part) {
        player.play().commands().run("restart");
        player.frames(3);
        player.drag(player.item("part " + part), player.at({-1.8, 1.2}));
        player.key(SDLK_SPACE);
        player.simulate(400);
        player.key(SDLK_s, KMOD_LCTRL);
        player.app().context().kinds.wait();
        player.frames(2);
    }
    void openPage() {
        player.key(SDLK_ESCAPE);
        player.frames(3);
        player.clickItem("menu.solutions");
        player.frames(3);
    }
    Player player;
};

TEST_F(SolutionsList, AreLoadedAndRun) {
    solveAndSave("spanner");
    ASSERT_EQ(saved().size(), 1U);
    player.play().commands().run("restart");
    EXPECT_TRUE(player.session().placed().empty());
    openPage();
    expectTidy(player, "the list of solutions");
    player.look("solutions-720");
    EXPECT_TRUE(player.shows("load solution 2")) << "the recorded one of the same kind";
    EXPECT_FALSE(player.shows("delete solution 2")) << "it belongs to the level";
    EXPECT_FALSE(player.shows("load solution 3")) << "those of other kinds are not given away";
    player.clickItem("load solution 1");
    player.frames(2);
    EXPECT_FALSE(player.app().menu().isOpen());
    ASSERT_EQ(player.session().placed().size(), 1U);
    EXPECT_EQ(player.session().placed()[0].placement.part, "spanner");
    player.key(SDLK_SPACE);
    player.simulate(400);
    EXPECT_TRUE(player.session().solved());
}

TEST_F(SolutionsList, AreRenamedAndDeleted) {
    solveAndSave("steel bar");
    solveAndSave("spanner");
    ASSERT_EQ(saved().size(), 2U);
    openPage();
    player.clickItem("rename solution 1");
    player.frames(3);
    for (char const letter : std::string("bridge")) {
        SDL_Event event{};
        event.type = SDL_TEXTINPUT;
        event.text.text[0] = letter;
        SDL_PushEvent(&event);
        player.frame();
    }
    player.key(SDLK_RETURN);
    player.frames(2);
    EXPECT_EQ(saved()[0].name, "bridge");
    EXPECT_EQ(player.app().menu().page(), MenuPage::solutions) << "Enter only ended the typing";
    player.clickItem("rename solution 1");
    player.frames(3);
    player.key(SDLK_ESCAPE);
    player.frames(2);
    EXPECT_EQ(player.app().menu().page(), MenuPage::solutions) << "Esc, too";
    EXPECT_EQ(saved()[0].name, "bridge");
    player.clickItem("delete solution 2");
    player.frames(2);
    EXPECT_EQ(saved().size(), 2U) << "it asks first";
    player.clickItem("delete solution 2");
    player.frames(2);
    ASSERT_EQ(saved().size(), 1U);
    EXPECT_EQ(saved()[0].name, "bridge");
}

TEST_F(SolutionsList, AreUsedWithKeysAlone) {
    solveAndSave("steel bar");
    player.play().commands().run("restart");
    player.key(SDLK_ESCAPE);
    player.frames(3);
    for (int i = 0; i < 3; ++i) { // resume, start again, solutions
        player.key(SDLK_DOWN);
    }
    player.key(SDLK_RETURN);
    player.frames(3);
    ASSERT_EQ(player.app().menu().page(), MenuPage::solutions);
    player.key(SDLK_RETURN); // the ring is at the first button, "Load"
    player.frames(2);
    EXPECT_EQ(player.session().placed().size(), 1U);
}

TEST(SolutionsPage, NamesTheKeyThatSavesWhicheverItIs) {
    useLanguage("en");
    KeyBindings keys(commandLists());
    EXPECT_NE(noSolutionsYet(keys).find("Ctrl+S"), std::string::npos) << noSolutionsYet(keys);
    auto const all = keys.commands();
    auto const save =
        std::find_if(all.begin(), all.end(), [](CommandInfo const* one) { return one->id == "save"; });
    ASSERT_NE(save, all.end());
    EXPECT_FALSE(keys.bind(**save, withCtrl(SDLK_k)));
    EXPECT_NE(noSolutionsYet(keys).find("Ctrl+K"), std::string::npos) << noSolutionsYet(keys);
    EXPECT_EQ(noSolutionsYet(keys).find("Ctrl+S"), std::string::npos) << noSolutionsYet(keys);
    keys.unbind(**save);
    EXPECT_EQ(noSolutionsYet(keys).find_first_of("{}+"), std::string::npos) << noSolutionsYet(keys);
    EXPECT_NE(noSolutionsYet(keys).find("disk"), std::string::npos) << noSolutionsYet(keys);
}

} // namespace
} // namespace solutions_page_test
} // namespace trembler::ui::test
