// Assigning keys to commands: with the keyboard alone, and with the mouse for everything but the key itself.
#include "tests/game/ui/virtual_pad.hpp"

#include <algorithm>

namespace trembler::ui::test {
namespace {

class AssigningKeys : public testing::Test {
protected:
    AssigningKeys() {
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder);
        start();
    }

    void start() {
        player.reset();
        player = std::make_unique<Player>(render::Size{1280, 720}, folder / "profile.json");
        player->open(levelsFolder() / "first/1-first-contact.json");
    }
    [[nodiscard]] MenuPage page() const { return player->app().menu().page(); }
    void openByMouse() {
        player->openKeysPage();
        ASSERT_EQ(page(), MenuPage::keys);
    }
    void press(SDL_Keycode key, int times) {
        for (int i = 0; i < times; ++i) {
            player->key(key);
        }
    }
    [[nodiscard]] std::string keysOf(std::string_view id) const {
        std::string all;
        for (Chord const& chord : player->app().context().keys.keysOf(id)) {
            if (!render::isPadKey(chord.key)) {
                all += (all.empty() ? "" : " ") + nameOf(chord);
            }
        }
        return all;
    }
    /// The button of a command in the list.
    [[nodiscard]] int rowOf(std::string_view id) const {
        auto const commands = player->app().context().keys.inGroups();
        auto const found = std::find_if(commands.begin(), commands.end(),
                                        [&](CommandInfo const* command) { return command->id == id; });
        return static_cast<int>(found - commands.begin());
    }
    [[nodiscard]] KeysPage const& keysPage() const { return player->app().menu().keysPage(); }

    std::filesystem::path const folder = testFolder() / "profile";
    std::unique_ptr<Player> player;
};

TEST_F(AssigningKeys, ByMouse) {
    openByMouse();
    player->scrollTo("key bindings", "key of undo");
    player->clickItem("key of undo");
    EXPECT_TRUE(keysPage().waiting());
    player->look("changing-a-key-720");
    player->key(SDLK_LCTRL, KMOD_LCTRL); // a modifier alone is not yet a choice
    EXPECT_TRUE(keysPage().waiting());
    player->key(SDLK_k, KMOD_LCTRL);
    EXPECT_FALSE(keysPage().waiting());
    EXPECT_EQ(keysOf("undo"), "Ctrl+K");
    // The new key is saved, and works.
    start();
    EXPECT_EQ(keysOf("undo"), "Ctrl+K");
    player->drag(player->item("part steel bar"), player->at({-1.8, 1.5}));
    player->key(SDLK_z, KMOD_LCTRL);
    EXPECT_EQ(player->session().placed().size(), 1U);
    player->key(SDLK_k, KMOD_LCTRL);
    EXPECT_TRUE(player->session().placed().empty());
    openByMouse();
    player->scrollTo("key bindings", "no key for undo");
    player->clickItem("no key for undo");
    EXPECT_EQ(keysOf("undo"), "");
    player->clickItem("reset keys");
    EXPECT_EQ(keysOf("undo"), "Ctrl+Z");
    player->clickItem("close keys");
    EXPECT_EQ(page(), MenuPage::settings);
    start();
    EXPECT_EQ(keysOf("undo"), "Ctrl+Z");
}

TEST_F(AssigningKeys, AKeyOfAnotherCommandIsRefused) {
    openByMouse();
    player->scrollTo("key bindings", "key of undo");
    player->clickItem("key of undo");
    player->key(SDLK_SPACE);
    EXPECT_TRUE(keysPage().waiting()) << "it still waits for a key";
    EXPECT_NE(keysPage().complaint().find("\"Run\""), std::string::npos) << keysPage().complaint();
    player->frames(2);
    player->look("refused-key-720");
    EXPECT_EQ(keysOf("undo"), "Ctrl+Z");
    EXPECT_EQ(keysOf("run"), "Space");
    player->key(SDLK_ESCAPE); // keeps the key, and the page stays open
    EXPECT_FALSE(keysPage().waiting());
    EXPECT_EQ(page(), MenuPage::keys);
    EXPECT_EQ(keysOf("undo"), "Ctrl+Z");
    player->key(SDLK_ESCAPE);
    EXPECT_EQ(page(), MenuPage::settings);
    player->key(SDLK_ESCAPE);
    EXPECT_EQ(page(), MenuPage::main);
    player->key(SDLK_ESCAPE);
    EXPECT_FALSE(player->app().menu().isOpen());
}

TEST_F(AssigningKeys, ByKeyboardAlone) {
    player->key(SDLK_F1);
    player->frames(2);
    ASSERT_EQ(page(), MenuPage::help);
    player->key(SDLK_DOWN);
    player->key(SDLK_RETURN);
    player->frames(2);
    ASSERT_EQ(page(), MenuPage::keys);
    int const row = rowOf("cut");
    press(SDLK_DOWN, row);
    player->key(SDLK_RETURN);
    ASSERT_TRUE(keysPage().waiting());
    player->key(SDLK_DOWN); // an arrow is a key, too, but this one belongs to another command
    EXPECT_NE(keysPage().complaint().find("\"Move down\""), std::string::npos) << keysPage().complaint();
    player->key(SDLK_F7);
    EXPECT_FALSE(keysPage().waiting());
    EXPECT_EQ(keysOf("cut"), "F7");
    player->key(SDLK_RETURN);
    player->key(SDLK_DELETE); // a key as well, but it belongs to another command
    EXPECT_TRUE(keysPage().waiting());
    EXPECT_EQ(keysOf("cut"), "F7");
    player->key(SDLK_DELETE, KMOD_LCTRL); // with Ctrl it belongs to no command
    EXPECT_EQ(keysOf("cut"), "Ctrl+Delete");
    player->key(SDLK_DELETE); // removes the key while the page does not wait for one
    EXPECT_EQ(keysOf("cut"), "");
    press(SDLK_UP, row + 1); // wraps from the first line to the last button
    player->key(SDLK_LEFT);
    player->key(SDLK_RETURN);
    EXPECT_EQ(keysOf("cut"), "X");
    player->key(SDLK_TAB);
    player->key(SDLK_RETURN);
    EXPECT_EQ(page(), MenuPage::help) << "back where it was opened";
}

// The key that leads back can be another one, but there always is one, and Esc ends the question for a key.
TEST_F(AssigningKeys, BackMayBeAnotherKeyButNotNone) {
    player->key(SDLK_F1);
    player->frames(2);
    player->key(SDLK_DOWN);
    player->key(SDLK_RETURN);
    player->frames(2);
    press(SDLK_DOWN, rowOf("back"));
    player->key(SDLK_DELETE);
    EXPECT_NE(keysPage().complaint().find("\"Back\""), std::string::npos) << keysPage().complaint();
    EXPECT_EQ(keysOf("back"), "Escape");
    player->key(SDLK_RETURN);
    ASSERT_TRUE(keysPage().waiting());
    player->key(SDLK_DOWN); // it moves things down in levels, and goes down in menus
    EXPECT_NE(keysPage().complaint().find("\"Move down\""), std::string::npos) << keysPage().complaint();
    player->key(SDLK_BACKSLASH);
    EXPECT_EQ(keysOf("back"), "\\");
    player->key(SDLK_ESCAPE);
    EXPECT_EQ(page(), MenuPage::keys) << "Esc means nothing now";
    player->key(SDLK_RETURN);
    ASSERT_TRUE(keysPage().waiting());
    player->key(SDLK_ESCAPE); // its usual key may be had again
    EXPECT_EQ(keysOf("back"), "Escape");
    player->key(SDLK_RETURN);
    player->key(SDLK_BACKSLASH);
    press(SDLK_UP, 1);
    player->key(SDLK_RETURN);
    ASSERT_TRUE(keysPage().waiting());
    player->key(SDLK_ESCAPE);
    EXPECT_FALSE(keysPage().waiting()) << "asked for a key of another command, the page gives up";
    EXPECT_EQ(page(), MenuPage::keys);
    player->key(SDLK_BACKSLASH);
    EXPECT_EQ(page(), MenuPage::help);
    player->key(SDLK_BACKSLASH);
    EXPECT_FALSE(player->app().menu().isOpen());
    player->key(SDLK_ESCAPE);
    EXPECT_FALSE(player->app().menu().isOpen());
    player->key(SDLK_BACKSLASH);
    EXPECT_EQ(page(), MenuPage::main) << "in a level it opens the menu";
}

// Every key of menus and every button may be another one. The new ones work, the old ones do not, and the
// mouse alone leads back to the defaults.
TEST_F(AssigningKeys, MenusObeyTheirNewKeysAndTheMouseRestoresTheOldOnes) {
    auto pad = std::make_unique<VirtualPad>();
    if (!pad->works()) {
        GTEST_SKIP() << "SDL has no virtual gamepads here: " << SDL_GetError();
    }
    player->frames(2);
    openByMouse();
    struct Choice {
        char const* id;
        SDL_Keycode key;
        SDL_GameControllerButton button;
    };
    // SDL reports that the button Guide is let go only after it was held for a while, so it gets its events
    // here.
    auto const button = [&](SDL_GameControllerButton which) {
        if (which != SDL_CONTROLLER_BUTTON_GUIDE) {
            return pad->press(*player, which);
        }
        for (auto const type : {SDL_CONTROLLERBUTTONDOWN, SDL_CONTROLLERBUTTONUP}) {
            SDL_Event event{};
            event.type = type;
            event.cbutton.button = static_cast<Uint8>(which);
            event.cbutton.state = type == SDL_CONTROLLERBUTTONDOWN ? SDL_PRESSED : SDL_RELEASED;
            render::synthetic::push(event);
            player->frames(2);
        }
    };
    auto const choose = [&](std::initializer_list<Choice> choices) {
        for (Choice const& choice : choices) {
            std::string const row = "key of " + std::string(choice.id);
            player->scrollTo("key bindings", row);
            player->clickItem(row);
            player->key(choice.key);
            EXPECT_FALSE(keysPage().waiting()) << choice.id << ": " << keysPage().complaint();
            player->clickItem(row);
            button(choice.button);
            EXPECT_FALSE(keysPage().waiting()) << choice.id << ": " << keysPage().complaint();
        }
    };
    choose({{"back", SDLK_BACKSLASH, SDL_CONTROLLER_BUTTON_GUIDE},
            {"menu-up", SDLK_i, SDL_CONTROLLER_BUTTON_RIGHTSTICK},
            {"menu-down", SDLK_k, SDL_CONTROLLER_BUTTON_LEFTSTICK},
            {"menu-press", SDLK_p, SDL_CONTROLLER_BUTTON_BACK}});
    player->look("keys-of-menus-720");
    start(); // they are kept
    pad.reset();
    pad = std::make_unique<VirtualPad>(); // plugged into the new program
    player->frames(2);
    EXPECT_EQ(keysOf("menu-down"), "K");
    auto const settingsBy = [&](auto const& down, auto const& press, auto const& back) {
        back();
        EXPECT_EQ(page(), MenuPage::main);
        player->moveTo({600, 5}); // hides the ring, which the first key shows again
        player->moveTo({605, 5});
        for (int i = 0; i < 5 && page() == MenuPage::main; ++i) {
            down();
        }
        press();
        bool const there = page() == MenuPage::settings;
        for (int i = 0; i < 2 && there; ++i) { // to the menu, and out of it
            back();
        }
        EXPECT_FALSE(there && player->app().menu().isOpen());
        return there;
    };
    EXPECT_TRUE(settingsBy([&] { player->key(SDLK_k); }, [&] { player->key(SDLK_p); },
                           [&] { player->key(SDLK_BACKSLASH); }));
    EXPECT_TRUE(settingsBy([&] { button(SDL_CONTROLLER_BUTTON_LEFTSTICK); },
                           [&] { button(SDL_CONTROLLER_BUTTON_BACK); },
                           [&] { button(SDL_CONTROLLER_BUTTON_GUIDE); }));
    player->key(SDLK_BACKSLASH);
    ASSERT_EQ(page(), MenuPage::main);
    for (SDL_Keycode const old : {SDLK_DOWN, SDLK_RETURN, SDLK_SPACE, SDLK_ESCAPE}) {
        player->key(old);
    }
    for (auto const old :
         {SDL_CONTROLLER_BUTTON_DPAD_DOWN, SDL_CONTROLLER_BUTTON_A, SDL_CONTROLLER_BUTTON_B}) {
        button(old);
    }
    EXPECT_EQ(page(), MenuPage::main) << "the old keys mean nothing";
    player->clickItem("menu.settings");
    player->frames(3);
    player->clickItem("Change the keys");
    player->frames(3);
    player->clickItem("reset keys");
    EXPECT_TRUE(player->app().context().keys.isDefault());
    for (int i = 0; i < 3; ++i) {
        player->key(SDLK_ESCAPE);
    }
    EXPECT_FALSE(player->app().menu().isOpen());
}

TEST_F(AssigningKeys, TheListIsTidyAtEverySize) {
    for (render::Size const size : {render::Size{1280, 720}, render::Size{1920, 1080}}) {
        player.reset();
        player = std::make_unique<Player>(size, folder / "profile.json");
        player->open(levelsFolder() / "first/1-first-contact.json");
        openByMouse();
        auto const card = player->layout().card("key bindings");
        ASSERT_TRUE(card);
        EXPECT_GE(card->low.y, 0);
        EXPECT_LE(card->high.y, size.height);
        for (Placed const& placed : player->layout().cards()) {
            EXPECT_LE(placed.overflow, 1.0) << placed.name;
        }
        auto const& items = player->layout().items();
        EXPECT_GT(items.size(), 10U);
        for (std::size_t i = 0; i < items.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                EXPECT_FALSE(items[i].rect.overlaps(items[j].rect))
                    << items[i].name << " lies on " << items[j].name;
            }
        }
        player->look("changing-keys-" + std::to_string(size.height));
        player->key(SDLK_ESCAPE);
        player->frames(2);
        player->look("settings-with-keys-" + std::to_string(size.height));
        player->key(SDLK_ESCAPE);
        player->key(SDLK_ESCAPE);
        player->key(SDLK_F1);
        player->frames(3);
        player->look("keys-page-" + std::to_string(size.height));
    }
}

} // namespace
} // namespace trembler::ui::test
