// The second player's own buttons are chosen on the page of keys, like all others, and kept.
#include "game/ui/play/mouse/second_player.hpp"
#include "runtime/placement.hpp"
#include "tests/game/ui/virtual_pad.hpp"

#include <fstream>

namespace trembler::ui::test {
namespace second_player_test {
namespace {

auto const experimentOne = levelsFolder() / "experiments/1-switched-electromagnet.json";

class SecondPlayersKeys : public testing::Test {
protected:
    SecondPlayersKeys() {
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder);
    }

    /// The program begins anew; gamepads must be plugged in again.
    void start() {
        player.reset();
        player = std::make_unique<Player>(render::Size{1280, 720}, folder / "profile.json");
        player->open(experimentOne);
    }
    void openKeys() {
        player->openKeysPage();
        ASSERT_EQ(player->app().menu().page(), MenuPage::keys);
    }
    void closeKeys() {
        for (int i = 0; i < 3; ++i) {
            player->key(SDLK_ESCAPE);
        }
        ASSERT_FALSE(player->app().menu().isOpen());
        player->frames(3);
    }
    /// The page waits for a key of this command from now on.
    void ask(std::string const& id) {
        std::string const row = "key of " + id;
        player->scrollTo("key bindings", row);
        player->clickItem(row);
        ASSERT_TRUE(keysPage().waiting()) << id;
    }
    [[nodiscard]] KeysPage const& keysPage() const { return player->app().menu().keysPage(); }
    [[nodiscard]] std::string keysOf(std::string_view id) const {
        std::string all;
        for (Chord const& chord : player->app().context().keys.keysOf(id)) {
            all += (all.empty() ? "" : " ") + nameOf(chord);
        }
        return all;
    }
    [[nodiscard]] Vec2 lever() const {
        World const& world = player->session().world();
        return world.find<Position>(world.store().find("switch"))->value;
    }
    [[nodiscard]] bool holdsLever() const {
        return player->play().secondHand().held() == player->session().world().store().find("switch");
    }
    void run() {
        player->key(SDLK_SPACE);
        player->simulate(60);
        ASSERT_NE(player->session().mode(), SessionMode::building);
    }

    std::filesystem::path const folder = testFolder() / "profile";
    std::unique_ptr<Player> player;
};

TEST_F(SecondPlayersKeys, AreChosenByPressingThemAndAreKept) {
    start();
    {
        VirtualPad const first;
        VirtualPad const second;
        if (!first.works() || !second.works()) {
            GTEST_SKIP() << "SDL has no virtual gamepads here: " << SDL_GetError();
        }
        player->frames(2);
        openKeys();
        ask("second-grab");
        player->look("second-players-keys-720");
        second.press(*player, SDL_CONTROLLER_BUTTON_Y); // the first player's gamepad pauses with it
        EXPECT_FALSE(keysPage().waiting()) << keysPage().complaint();
        for (auto const& [id, axis, way] :
             {std::tuple{"second-left", SDL_CONTROLLER_AXIS_RIGHTX, Sint16{-32000}},
              std::tuple{"second-right", SDL_CONTROLLER_AXIS_RIGHTX, Sint16{32000}},
              std::tuple{"second-up", SDL_CONTROLLER_AXIS_RIGHTY, Sint16{-32000}},
              std::tuple{"second-down", SDL_CONTROLLER_AXIS_RIGHTY, Sint16{32000}}}) {
            ask(id);
            second.push(*player, axis, way);
            EXPECT_FALSE(keysPage().waiting()) << id << ": " << keysPage().complaint();
        }
    }
    start();
    EXPECT_EQ(keysOf("second-grab"), "Pad Y");
    EXPECT_EQ(keysOf("second-left"), "Pad RS Left");
    EXPECT_EQ(keysOf("second-down"), "Pad RS Down");
    VirtualPad const first;
    VirtualPad const second;
    player->frames(2);
    run();
    auto const at = [&] { return player->play().secondPointer().at(); };
    Vec2 const before = at();
    second.lean(*player, SDL_CONTROLLER_AXIS_LEFTX, 32000);
    player->frames(10);
    EXPECT_EQ(at(), before) << "the left stick is nobody's of the second player any more";
    second.lean(*player, SDL_CONTROLLER_AXIS_LEFTX, 0);
    for (int i = 0; i < 300 && length(at() - lever()) > 0.035; ++i) {
        Vec2 const way = lever() - at();
        double const far = std::max(length(way), 0.1);
        second.lean(*player, SDL_CONTROLLER_AXIS_RIGHTX, static_cast<Sint16>(32000 * way.x / far));
        second.lean(*player, SDL_CONTROLLER_AXIS_RIGHTY, static_cast<Sint16>(-32000 * way.y / far));
    }
    second.lean(*player, SDL_CONTROLLER_AXIS_RIGHTX, 0);
    second.lean(*player, SDL_CONTROLLER_AXIS_RIGHTY, 0);
    second.hold(*player, SDL_CONTROLLER_BUTTON_A, true);
    player->frames(25);
    EXPECT_FALSE(holdsLever()) << "A is no longer their button";
    second.hold(*player, SDL_CONTROLLER_BUTTON_A, false);
    second.hold(*player, SDL_CONTROLLER_BUTTON_Y, true);
    player->frames(25);
    EXPECT_TRUE(holdsLever());
    EXPECT_FALSE(player->session().mode() == SessionMode::paused) << "of the second player Y is no pause";
    second.hold(*player, SDL_CONTROLLER_BUTTON_Y, false);
    player->frames(2);
    EXPECT_FALSE(holdsLever());
    first.press(*player, SDL_CONTROLLER_BUTTON_Y);
    EXPECT_TRUE(player->session().mode() == SessionMode::paused) << "of the first player it is";
}

TEST_F(SecondPlayersKeys, ConflictAmongThemselvesAndWithKeysOfTheKeyboard) {
    start();
    VirtualPad const pad;
    if (!pad.works()) {
        GTEST_SKIP() << "SDL has no virtual gamepads here: " << SDL_GetError();
    }
    player->frames(2);
    openKeys();
    ask("second-grab");
    pad.press(*player, SDL_CONTROLLER_BUTTON_DPAD_UP);
    EXPECT_TRUE(keysPage().waiting());
    EXPECT_NE(keysPage().complaint().find("\"Second player: up\""), std::string::npos)
        << keysPage().complaint();
    player->key(SDLK_SPACE);
    EXPECT_TRUE(keysPage().waiting());
    EXPECT_NE(keysPage().complaint().find("\"Run\""), std::string::npos) << keysPage().complaint();
    player->key(SDLK_KP_5);
    EXPECT_FALSE(keysPage().waiting()) << keysPage().complaint();
    EXPECT_EQ(keysOf("second-grab"), "Keypad 5 Pad A") << "a key replaces no button";
    ask("inspect");
    player->key(SDLK_KP_5);
    EXPECT_NE(keysPage().complaint().find("\"Second player: take hold\""), std::string::npos)
        << keysPage().complaint();
    pad.press(*player, SDL_CONTROLLER_BUTTON_A);
    EXPECT_NE(keysPage().complaint().find("\"Mouse button\""), std::string::npos)
        << "of the first player's commands another one has it: " << keysPage().complaint();
    player->key(SDLK_ESCAPE);
    player->clickItem("reset keys");
    EXPECT_EQ(keysOf("second-grab"), "Pad A");
    EXPECT_EQ(keysOf("second-left"), "Pad Left");
}

TEST_F(SecondPlayersKeys, MayBeKeysOfTheKeyboardForTwoWithoutAGamepad) {
    start();
    openKeys();
    for (auto const& [id, key] : {std::pair{"second-left", SDLK_KP_4}, std::pair{"second-right", SDLK_KP_6},
                                  std::pair{"second-up", SDLK_KP_8}, std::pair{"second-down", SDLK_KP_2},
                                  std::pair{"second-grab", SDLK_KP_5}}) {
        ask(id);
        player->key(key);
        EXPECT_FALSE(keysPage().waiting()) << id << ": " << keysPage().complaint();
    }
    closeKeys();
    run();
    auto const& pointer = player->play().secondPointer();
    EXPECT_FALSE(pointer.active()) << "nobody has pressed one of the keys";
    auto const lead = [&](double from, double to, SDL_Keycode less, SDL_Keycode more, auto const& now) {
        SDL_Keycode const key = to > from ? more : less;
        player->hold(key);
        for (int i = 0; i < 300 && (to > from ? now() < to : now() > to); ++i) {
            player->frames(1);
        }
        player->letGo(key);
    };
    player->hold(SDLK_KP_4);
    player->letGo(SDLK_KP_4);
    ASSERT_TRUE(pointer.active());
    lead(pointer.at().x, lever().x, SDLK_KP_4, SDLK_KP_6, [&] { return pointer.at().x; });
    lead(pointer.at().y, lever().y, SDLK_KP_2, SDLK_KP_8, [&] { return pointer.at().y; });
    EXPECT_TRUE(pointer.active()) << "the second player stays";
    player->hold(SDLK_KP_5);
    player->frames(25);
    EXPECT_TRUE(holdsLever());
    EXPECT_FALSE(player->play().hand().held().valid()) << "the first player's hand is empty";
    Vec2 const before = lever();
    player->hold(SDLK_KP_8);
    player->frames(40);
    EXPECT_GT(lever().y, before.y + 0.2) << "it is lifted";
    player->letGo(SDLK_KP_8);
    player->letGo(SDLK_KP_5);
    player->frames(2);
    EXPECT_FALSE(player->play().secondHand().held().valid());
    auto const inputs = player->session().inputs();
    EXPECT_TRUE(std::all_of(inputs.begin(), inputs.end(), [](auto const& input) { return input.hand == 1; }));
}

// A button that the second player does not want is an ordinary one again.
TEST_F(SecondPlayersKeys, MayBeNone) {
    std::ofstream(folder / "profile.json") << R"({"pad_is_second": true, "keys": {"second-grab": []}})";
    start();
    EXPECT_EQ(keysOf("second-grab"), "");
    VirtualPad const pad;
    if (!pad.works()) {
        GTEST_SKIP() << "SDL has no virtual gamepads here: " << SDL_GetError();
    }
    player->frames(2);
    run();
    pad.leadSecondPointer(*player, lever());
    pad.hold(*player, SDL_CONTROLLER_BUTTON_A, true);
    player->frames(25);
    EXPECT_FALSE(holdsLever());
    EXPECT_TRUE(player->app().context().input.keyHeld(render::padKey(SDL_CONTROLLER_BUTTON_A)));
    pad.hold(*player, SDL_CONTROLLER_BUTTON_A, false);
}

// Written before these commands had names: what the first player chose does not concern the second one.
TEST_F(SecondPlayersKeys, OldSettingsFilesLoad) {
    std::ofstream(folder / "profile.json") << R"({"ui_scale": 1.15, "pad_is_second": true,
               "keys": {"act": ["Return", "Pad Up"], "move-up": ["Up", "Pad A"], "second-hand": ["F5", "Pad Guide"]}})";
    start();
    auto const troubles =
        KeyBindings(player->app().context().keys).load(player->app().context().profile.keys());
    EXPECT_TRUE(troubles.empty()) << troubles.front();
    EXPECT_EQ(keysOf("move-up"), "Up Pad A");
    EXPECT_EQ(keysOf("second-hand"), "F5 Pad Guide");
    EXPECT_EQ(keysOf("second-up"), "Pad Up");
    EXPECT_EQ(keysOf("second-grab"), "Pad A");
    EXPECT_EQ(secondPadButtons(player->app().context().keys), render::SecondPadButtons{});
}

} // namespace
} // namespace second_player_test
} // namespace trembler::ui::test
