// Texts and numbers by a gamepad alone, with real events of a gamepad, in fields of menus and of the editor.
#include "game/ui/app/menu/settings_page.hpp"
#include "game/ui/shared/letters/screen_keyboard.hpp"
#include "tests/game/ui/edit/editor_kit.hpp"
#include "tests/game/ui/shared/letters/pad_typist.hpp"

#include <string>
#include <vector>

namespace trembler::ui::test {
namespace screen_keyboard_test {
namespace {

auto const openedLevel = levelsFolder() / "first/1-first-contact.json";
std::string const openedId = "first/1-first-contact.json";

class LettersByPad : public testing::Test {
protected:
    void SetUp() override {
        if (!pad.works()) {
            GTEST_SKIP() << "SDL has no virtual gamepads here: " << SDL_GetError();
        }
        std::filesystem::remove_all(designer.films()); // solutions of an earlier run
        designer.frames(2);
    }
    void press(SDL_GameControllerButton button, int times = 1) {
        for (int i = 0; i < times; ++i) {
            pad.press(designer, button);
        }
    }
    /// The page of the level in the editor has the buttons, with the ring at the title.
    void goToTitle() {
        press(SDL_CONTROLLER_BUTTON_LEFTSTICK);
        for (int i = 0; i < 7 && designer.parts().tab != Tab::level; ++i) {
            press(SDL_CONTROLLER_BUTTON_RIGHTSHOULDER);
        }
        ASSERT_EQ(designer.parts().tab, Tab::level);
        press(SDL_CONTROLLER_BUTTON_DPAD_DOWN); // the ring is seen from the first move on
        press(SDL_CONTROLLER_BUTTON_DPAD_UP, 2);
    }
    /// Opens the menu and presses a row of it; the first one is 0, those in one row count once.
    void chooseInMenu(int row, bool right) {
        press(SDL_CONTROLLER_BUTTON_START);
        designer.frames(2);
        ASSERT_EQ(designer.app().menu().page(), MenuPage::main);
        press(SDL_CONTROLLER_BUTTON_DPAD_DOWN, row); // the ring is seen since the title
        if (right) {
            press(SDL_CONTROLLER_BUTTON_DPAD_RIGHT);
        }
        press(SDL_CONTROLLER_BUTTON_A);
    }
    /// Runs a command of the level from the menu's list.
    void runFromList(std::string const& id) {
        chooseInMenu(5, true);
        ASSERT_EQ(designer.app().menu().page(), MenuPage::commands);
        CommandSet const& commands = designer.play().commands();
        CommandInfo const& wanted = commands.info(commands.indexOf(id));
        int row = 0;
        for (std::size_t i = 0; i < commands.size(); ++i) {
            CommandInfo const& info = commands.info(i);
            bool const before =
                info.group < wanted.group || (info.group == wanted.group && i < commands.indexOf(id));
            row += before && commands.available(i) && !info.leads && info.use != KeyUse::held ? 1 : 0;
        }
        press(SDL_CONTROLLER_BUTTON_DPAD_DOWN, row);
        press(SDL_CONTROLLER_BUTTON_A);
        designer.frames(3);
    }
    bool open() { return typist.keyboard().open(); }

    Designer designer;
    VirtualPad pad;
    PadTypist typist{designer, pad};
};

TEST_F(LettersByPad, FromTheTitleToASavedSolutionWithAName) {
    press(SDL_CONTROLLER_BUTTON_DPAD_DOWN); // the ring, at "Play"
    press(SDL_CONTROLLER_BUTTON_A);
    ASSERT_NE(designer.findPlay(), nullptr);
    ASSERT_EQ(designer.app().screen().level().filename(), openedLevel.filename());
    ASSERT_TRUE(designer.session().place({"steel bar", {-1.8, 1.3}, 0, ""}));
    press(SDL_CONTROLLER_BUTTON_X); // run
    designer.simulate(400);
    ASSERT_TRUE(designer.session().solved());
    auto const saved = [&] { return designer.app().context().solutions.of(openedId); };
    ASSERT_TRUE(saved().empty());
    runFromList("save");
    designer.app().context().kinds.wait();
    designer.frames(2);
    ASSERT_EQ(saved().size(), 1U);
    chooseInMenu(2, false);
    ASSERT_EQ(designer.app().menu().page(), MenuPage::solutions);
    press(SDL_CONTROLLER_BUTTON_DPAD_RIGHT);
    press(SDL_CONTROLLER_BUTTON_A); // rename
    designer.frames(3);
    ASSERT_TRUE(open());
    typist.type("Bar no. 7");
    designer.look("letters-solution");
    press(SDL_CONTROLLER_BUTTON_START);
    designer.frames(3);
    EXPECT_FALSE(open());
    EXPECT_EQ(saved()[0].name, "Bar no. 7");
    EXPECT_EQ(designer.app().menu().page(), MenuPage::solutions) << "the button only ended the typing";
    press(SDL_CONTROLLER_BUTTON_A);
    designer.frames(3);
    if (!open()) { // the ring may be at the first button again
        press(SDL_CONTROLLER_BUTTON_DPAD_RIGHT);
        press(SDL_CONTROLLER_BUTTON_A);
        designer.frames(3);
    }
    ASSERT_TRUE(open());
    typist.type("x");
    press(SDL_CONTROLLER_BUTTON_B);
    designer.frames(3);
    EXPECT_FALSE(open());
    EXPECT_EQ(saved()[0].name, "Bar no. 7") << "given up";
    EXPECT_EQ(designer.app().menu().page(), MenuPage::solutions);
}

TEST_F(LettersByPad, TextsOfALevelWithUmlautsInGerman) {
    changeSettings(designer.app().context(), {.language = "de"});
    press(SDL_CONTROLLER_BUTTON_DPAD_DOWN, 5); // play, levels, gallery, free play, editor
    press(SDL_CONTROLLER_BUTTON_A);
    designer.frames(4);
    ASSERT_NE(dynamic_cast<EditScreen*>(&designer.app().screen()), nullptr);
    goToTitle();
    press(SDL_CONTROLLER_BUTTON_A);
    ASSERT_TRUE(open());
    EXPECT_TRUE(typist.pressKey([](LetterKey const& key) { return key.text == "ü"; }));
    press(SDL_CONTROLLER_BUTTON_X, 40); // all that was there, and more
    typist.type({"G", "r", "ü", "ß", "e", " ", "&", "Ö"});
    press(SDL_CONTROLLER_BUTTON_START);
    designer.frames(3);
    EXPECT_FALSE(open());
    EXPECT_EQ(designer.tree()["title"], "Grüße &Ö");
    std::size_t const before = designer.parts().document.done();
    // The story, in several lines.
    press(SDL_CONTROLLER_BUTTON_DPAD_DOWN);
    press(SDL_CONTROLLER_BUTTON_A);
    ASSERT_TRUE(open());
    typist.type("one");
    ASSERT_TRUE(typist.pressKey(KeyAct::newLine));
    typist.type("twp");
    ASSERT_TRUE(typist.pressKey(KeyAct::erase));
    typist.type("o");
    press(SDL_CONTROLLER_BUTTON_LEFTSHOULDER, 7); // to the beginning
    typist.type("z");
    designer.look("letters-story");
    ASSERT_TRUE(typist.pressKey(KeyAct::done));
    designer.frames(3);
    EXPECT_FALSE(open());
    EXPECT_EQ(designer.tree()["text"], "zone\ntwo");
    EXPECT_EQ(designer.parts().document.done(), before + 1) << "one step of undo";
}

TEST_F(LettersByPad, NumbersAndSearchFields) {
    designer.editNew();
    // Found in the catalogue.
    press(SDL_CONTROLLER_BUTTON_LEFTSTICK);
    press(SDL_CONTROLLER_BUTTON_DPAD_DOWN);
    press(SDL_CONTROLLER_BUTTON_DPAD_UP, 3);
    press(SDL_CONTROLLER_BUTTON_A);
    ASSERT_TRUE(open());
    typist.type("magn");
    press(SDL_CONTROLLER_BUTTON_START);
    designer.frames(2);
    EXPECT_EQ(designer.parts().searched, "magn");
    EXPECT_FALSE(designer.shows("part crate"));
    EXPECT_TRUE(designer.parts().panelKeys);
    // A number that can be dragged: the first one of the tools' settings.
    press(SDL_CONTROLLER_BUTTON_RIGHTSHOULDER, 2);
    ASSERT_EQ(designer.parts().tab, Tab::properties);
    press(SDL_CONTROLLER_BUTTON_DPAD_DOWN);
    press(SDL_CONTROLLER_BUTTON_DPAD_UP, 3);
    press(SDL_CONTROLLER_BUTTON_X);
    ASSERT_TRUE(open());
    EXPECT_EQ(typist.keyboard().keys().front().text, "7") << "digits only";
    typist.type("0.25");
    designer.look("letters-number");
    press(SDL_CONTROLLER_BUTTON_START);
    designer.frames(2);
    EXPECT_NEAR(designer.parts().snapping.grid, 0.25, 1e-9);
    // The list of commands has a field that always has the keys: its letters come when asked for.
    press(SDL_CONTROLLER_BUTTON_B);
    press(SDL_CONTROLLER_BUTTON_A);
    designer.frames(2);
    ASSERT_TRUE(designer.showsCard("command palette"));
    EXPECT_FALSE(open());
    press(SDL_CONTROLLER_BUTTON_X);
    ASSERT_TRUE(open());
    typist.type("redo");
    press(SDL_CONTROLLER_BUTTON_B);
    EXPECT_FALSE(open());
    EXPECT_TRUE(designer.showsCard("command palette"));
    EXPECT_FALSE(designer.shows("run edit-test"));
    press(SDL_CONTROLLER_BUTTON_B);
    EXPECT_FALSE(designer.showsCard("command palette"));
}

TEST_F(LettersByPad, HidesFromARealKeyboardAndFromTheMouse) {
    designer.editNew();
    goToTitle();
    press(SDL_CONTROLLER_BUTTON_A);
    ASSERT_TRUE(open());
    designer.key(SDLK_END);
    EXPECT_FALSE(open());
    EXPECT_TRUE(designer.app().context().gui.wantsKeyboard()) << "the field still has the keys";
    press(SDL_CONTROLLER_BUTTON_DPAD_LEFT);
    EXPECT_TRUE(open()) << "the gamepad again";
    designer.click({300, 300});
    designer.frames(2);
    EXPECT_FALSE(open());
}

TEST_F(LettersByPad, AHeldDirectionRepeatsAndRestsWhenItIsLetGo) {
    designer.editNew();
    goToTitle();
    press(SDL_CONTROLLER_BUTTON_A);
    ASSERT_TRUE(open());
    std::size_t const from = typist.keyboard().chosen();
    pad.hold(designer, SDL_CONTROLLER_BUTTON_DPAD_RIGHT, true);
    EXPECT_EQ(typist.keyboard().chosen(), from + 1);
    EXPECT_TRUE(typist.keyboard().busy());
    designer.frames(40);
    EXPECT_GE(typist.keyboard().chosen(), from + 3);
    pad.hold(designer, SDL_CONTROLLER_BUTTON_DPAD_RIGHT, false);
    designer.frames(2);
    EXPECT_FALSE(typist.keyboard().busy());
    std::size_t const there = typist.keyboard().chosen();
    designer.frames(60);
    EXPECT_EQ(typist.keyboard().chosen(), there);
    EXPECT_TRUE(designer.app().resting());
}

/// The card and its keys lie on the screen, and no key on another one.
TEST_F(LettersByPad, FitsIntoEverySize) {
    for (float const factor : {1.F, 1.6F}) {
        changeSettings(designer.app().context(), {.uiScale = factor});
        for (render::Size const size :
             {render::Size{800, 450}, {800, 600}, {1280, 720}, {1920, 1080}, {3840, 2160}}) {
            window().resize(size);
            designer.editNew();
            designer.frames(6);
            goToTitle();
            press(SDL_CONTROLLER_BUTTON_A);
            designer.frames(3);
            ASSERT_TRUE(open());
            auto const card = designer.layout().card("letters");
            ASSERT_TRUE(card);
            EXPECT_GE(card->low.x, 0);
            EXPECT_GE(card->low.y, 0);
            EXPECT_LE(card->high.x, size.width);
            EXPECT_LE(card->high.y, size.height);
            std::vector<Rect> keys;
            for (Placed const& item : designer.layout().items()) {
                if (item.name.starts_with("letter")) {
                    keys.push_back(item.rect);
                    EXPECT_GE(item.rect.high.y - item.rect.low.y, 9) << size.width << " " << item.name;
                    EXPECT_TRUE(card->contains(item.rect.middle()));
                }
            }
            EXPECT_EQ(keys.size(), typist.keyboard().keys().size());
            for (std::size_t i = 0; i < keys.size(); ++i) {
                for (std::size_t j = 0; j < i; ++j) {
                    EXPECT_FALSE(keys[i].overlaps(keys[j]));
                }
            }
            press(SDL_CONTROLLER_BUTTON_B);
            designer.app().showTitle();
        }
    }
    window().resize({1280, 720});
}

} // namespace
} // namespace screen_keyboard_test
} // namespace trembler::ui::test
