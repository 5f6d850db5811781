// The program holds one screen of any type; menus over it can be used with the keyboard alone.
#include "tests/game/ui/player.hpp"
#include "tests/game/ui/virtual_pad.hpp"

#include <optional>
#include <utility>

namespace trembler::ui::test {
namespace {

/// A screen that records the calls that it receives.
class NotedScreen final : public Screen {
public:
    NotedScreen(std::string& notes, std::optional<ScreenRequest> request)
        : notes_(notes), request_(std::move(request)), commands_({}, *this) {}
    ~NotedScreen() override { notes_ += "~"; }
    std::optional<ScreenRequest> update(double) override {
        notes_ += "u";
        return std::exchange(request_, std::nullopt);
    }
    void updateBehindMenu(double) override { notes_ += "m"; }
    [[nodiscard]] bool keepsPicture() const override { return keeps; }
    void draw() override { notes_ += "d"; }
    void pictureComplete() override { notes_ += "p"; }
    void leave() override { notes_ += "l"; }
    CommandSet& commands() override { return commands_; }
    [[nodiscard]] std::filesystem::path const& level() const override { return level_; }

    bool keeps = false; // pictures

private:
    std::string& notes_;
    std::optional<ScreenRequest> request_;
    CommandsOf<NotedScreen> commands_;
    std::filesystem::path level_;
};

class OneScreen : public testing::Test {
protected:
    OneScreen() { player.drawEveryPicture(); }

    void show(std::optional<ScreenRequest> request = {}) {
        player.app().show(std::make_unique<NotedScreen>(notes, std::move(request)));
    }
    std::string notes; // outlives the player
    Player player;
};

TEST_F(OneScreen, GetsItsCallsForEachPictureAndIsLeftOnce) {
    show();
    player.frames(2);
    EXPECT_EQ(notes, "udpudp");
    EXPECT_EQ(player.findPlay(), nullptr);
    player.app().showTitle();
    EXPECT_EQ(notes, "udpudpl~");
    player.frames(1);
    EXPECT_EQ(notes, "udpudpl~");
}

TEST_F(OneScreen, IsDrawnUnseenOnlyIfItUsesThePicture) {
    auto screen = std::make_unique<NotedScreen>(notes, std::nullopt);
    NotedScreen& shown = *screen;
    player.app().show(std::move(screen));
    EXPECT_TRUE(player.app().frame(1.0 / 60, false));
    EXPECT_TRUE(player.app().frame(1.0 / 60, false));
    EXPECT_EQ(notes, "uu");
    shown.keeps = true;
    EXPECT_TRUE(player.app().frame(1.0 / 60, false));
    EXPECT_EQ(notes, "uuudp");
    shown.keeps = false;
    EXPECT_TRUE(player.app().frame(1.0 / 60, false));
    EXPECT_TRUE(player.app().frame(1.0 / 60, true));
    EXPECT_EQ(notes, "uuudpuudp");
}

TEST_F(OneScreen, IsPausedBehindTheMenuThatItRequests) {
    show(request::OpenMenu{MenuPage::settings});
    player.frames(2);
    EXPECT_EQ(player.app().menu().page(), MenuPage::settings);
    EXPECT_EQ(notes, "udpmdp");
    player.key(SDLK_ESCAPE);
    EXPECT_FALSE(player.app().menu().isOpen());
}

TEST_F(OneScreen, IsReplacedByTheLevelThatItRequests) {
    show(request::OpenLevel{levelsFolder() / "first/1-first-contact.json"});
    player.frames(1);
    ASSERT_NE(player.findPlay(), nullptr);
    EXPECT_EQ(player.app().screen().level().filename(), "1-first-contact.json");
    EXPECT_TRUE(notes.starts_with("ul~")) << notes;
    show(request::ShowTitle{});
    player.frames(1);
    EXPECT_EQ(player.findPlay(), nullptr);
    EXPECT_TRUE(player.app().screen().level().empty());
}

TEST_F(OneScreen, StaysIfALevelCannotBeOpened) {
    show(request::OpenLevel{levelsFolder() / "no such level.json"});
    auto const toasts = player.app().context().toasts.count();
    player.frames(2);
    EXPECT_EQ(notes, "udpudp");
    EXPECT_EQ(player.app().context().toasts.count(), toasts + 1)
        << "the player gets a message with the reason";
}

TEST_F(OneScreen, EndsTheProgram) {
    show(request::Quit{});
    EXPECT_FALSE(player.frame());
}

TEST(KeyboardAlone, ALevelIsOpenedStartedAgainAndLeft) {
    Player player;
    player.key(SDLK_DOWN); // the focus appears on the first button, "Play"
    player.key(SDLK_RETURN);
    ASSERT_NE(player.findPlay(), nullptr);
    player.key(SDLK_h);
    EXPECT_EQ(player.play().hintsShown(), 1U);
    player.key(SDLK_ESCAPE);
    player.frames(2);
    player.look("ring-720");
    player.key(SDLK_DOWN); // from "Resume" to "Start the level again"
    player.key(SDLK_RETURN);
    EXPECT_FALSE(player.app().menu().isOpen());
    EXPECT_EQ(player.play().hintsShown(), 0U);
    player.key(SDLK_ESCAPE);
    player.frames(2);
    player.key(SDLK_h);
    player.key(SDLK_RETURN); // the menu begins at its first button again, "Resume"
    EXPECT_FALSE(player.app().menu().isOpen());
    player.key(SDLK_h);
    EXPECT_EQ(player.play().hintsShown(), 1U) << "keys of the level have no effect while the menu is open";
    player.key(SDLK_ESCAPE);
    player.frames(2);
    player.key(SDLK_UP);   // wraps to the last row
    player.key(SDLK_LEFT); // "Title screen"
    player.key(SDLK_RETURN);
    EXPECT_EQ(player.findPlay(), nullptr);
}

TEST(KeyboardAlone, SettingsAreChanged) {
    Player player;
    player.app().context().profile.setSettings({.volume = 50});
    player.open(levelsFolder() / "first/1-first-contact.json");
    player.key(SDLK_ESCAPE);
    player.frames(2);
    player.key(SDLK_DOWN);
    for (int i = 0; i < 4; ++i) {
        player.key(SDLK_DOWN); // resume, again, solutions, levels, settings
    }
    player.key(SDLK_RETURN);
    player.frames(2);
    ASSERT_EQ(player.app().menu().page(), MenuPage::settings);
    // The ring is at the first size.
    for (int i = 0; i < 2; ++i) {
        player.key(SDLK_DOWN); // languages and colours, volume: rows, not buttons
    }
    player.key(SDLK_RIGHT);
    player.key(SDLK_RIGHT);
    player.key(SDLK_LEFT);
    EXPECT_EQ(player.app().context().profile.settings().volume, 55);
    for (int i = 0; i < 5; ++i) {
        player.key(SDLK_TAB); // headphones, shadows, motion, full screen, the keys
    }
    player.moveTo({640, 20});
    player.moveTo({645, 20}); // the mouse removes the focus, so Enter presses nothing
    player.key(SDLK_RETURN);
    EXPECT_EQ(player.app().menu().page(), MenuPage::settings);
}

TEST(GamepadAlone, MenusAreUsedAndALevelIsOpened) {
    Player player;
    player.frames(2);
    VirtualPad const pad; // hot plug
    if (!pad.works()) {
        GTEST_SKIP() << "SDL has no virtual gamepads here: " << SDL_GetError();
    }
    player.frames(2);
    ASSERT_EQ(player.app().context().pads.count(), 1U);
    pad.press(player, SDL_CONTROLLER_BUTTON_DPAD_DOWN); // the ring appears, at "Play"
    pad.press(player, SDL_CONTROLLER_BUTTON_DPAD_DOWN);
    pad.press(player, SDL_CONTROLLER_BUTTON_A); // levels
    ASSERT_EQ(player.app().menu().page(), MenuPage::levels);
    pad.press(player, SDL_CONTROLLER_BUTTON_B);
    EXPECT_FALSE(player.app().menu().isOpen());
    for (int i = 0; i < 3; ++i) {
        pad.push(player, SDL_CONTROLLER_AXIS_LEFTY, 30000); // the stick acts like the directional pad
    }
    EXPECT_FALSE(player.app().menu().isOpen());
    for (int i = 0; i < 3; ++i) {
        pad.press(player, SDL_CONTROLLER_BUTTON_DPAD_UP);
    }
    pad.press(player, SDL_CONTROLLER_BUTTON_A); // "Play" again
    ASSERT_NE(player.findPlay(), nullptr);
}

TEST(AtRest, NoPictureIsDrawnThatShowsNothingNew) {
    Player player;
    player.app().context().profile.setSettings({.volume = 50});
    player.frames(400); // the bell has stopped
    EXPECT_TRUE(player.app().resting());
    render::Image const before = player.look("rest-720");
    player.frames(30);
    EXPECT_TRUE(player.app().resting());
    EXPECT_EQ(player.look("rest-720"), before);
    player.moveTo({640, 400});
    EXPECT_FALSE(player.app().resting()) << "the player is there";
    player.frames(60);
    EXPECT_TRUE(player.app().resting());
    player.open(levelsFolder() / "first/1-first-contact.json");
    player.key(SDLK_ESCAPE);
    player.frames(120);
    EXPECT_TRUE(player.app().resting()) << "a menu over a level";
    player.clickItem("menu.levels");
    player.frames(120);
    EXPECT_TRUE(player.app().resting()) << "all pictures of levels have been made";
}

/// Pictures in two seconds of which the window would draw each that may show something new.
int newPictures(Player& player) {
    int drawn = 0;
    for (int i = 0; i < 120; ++i) {
        drawn += player.app().resting() ? 0 : 1;
        player.frame();
    }
    return drawn;
}

TEST(AtRest, NothingIsDrawnOnAnyScreen) {
    Player player;
    auto const expectRest = [&](char const* screen) {
        player.frames(240); // objects come to rest, and messages disappear
        EXPECT_EQ(newPictures(player), 0) << screen;
    };
    expectRest("title");
    player.open(levelsFolder() / "first/2-into-the-basket.json"); // the first one shows what to do
    expectRest("a level before its start");
    player.key(SDLK_SPACE);
    player.frames(30);
    EXPECT_EQ(newPictures(player), 120) << "a running level";
    player.key(SDLK_p);
    expectRest("a paused level");
    player.key(SDLK_ESCAPE);
    expectRest("the menu");
    player.clickItem("menu.settings");
    expectRest("the settings");
    player.open(std::filesystem::path(TREMBLER_SOURCE_DIR) / "mods/wind/levels/1-a-fair-wind.json");
    expectRest("a level with a mod");
    player.key(SDLK_m);
    expectRest("the panel of mods");
    player.open(levelsFolder() / "first/2-into-the-basket.json");
    player.key(SDLK_b);
    player.frames(60); // in these, and the frames of expectRest(), its message disappears
    expectRest("a level with a time budget");
    auto const toasts = player.app().context().toasts.count();
    player.key(SDLK_PERIOD);
    EXPECT_EQ(player.app().context().toasts.count(), toasts + 1) << "the new budget is shown at once";
    EXPECT_FALSE(player.app().resting());
    player.key(SDLK_c);
    player.frames(60);
    expectRest("the panel of components, with a time budget");
    player.app().edit({});
    expectRest("the editor");
    player.key(SDLK_p, KMOD_LCTRL); // with a cursor in a field
    player.frames(4);
    ASSERT_TRUE(player.app().context().gui.wantsKeyboard());
    expectRest("a field for letters");
}

TEST(Kept, WhatWasBuiltIsThereWhenTheLevelIsOpenedAgain) {
    auto const folder = testFolder() / "kept";
    std::filesystem::remove_all(folder);
    std::filesystem::remove_all(testFolder() / "crashed"); // of an earlier run
    auto const level = levelsFolder() / "first/1-first-contact.json";
    {
        Player player({1280, 720}, folder / "profile.json");
        player.open(level);
        player.drag(player.item("part steel bar"), player.at({-1.8, 1.5}));
        ASSERT_EQ(player.session().placed().size(), 1U);
        player.app().showTitle(); // leaves it at once
        player.open(level);
        EXPECT_EQ(player.session().placed().size(), 1U);
        player.drag(player.item("part spanner"), player.at({-2.6, 2.2}));
        player.frames(130); // two seconds, then the program is killed
        std::filesystem::copy(folder, testFolder() / "crashed",
                              std::filesystem::copy_options::recursive |
                                  std::filesystem::copy_options::overwrite_existing);
    }
    Player player({1280, 720}, testFolder() / "crashed" / "profile.json");
    player.open(level);
    EXPECT_EQ(player.session().placed().size(), 2U);
    player.app().showTitle();
    player.frames(3);
    player.clickItem("free play");
    ASSERT_NE(player.findPlay(), nullptr);
    EXPECT_EQ(player.session().toolbox().size(), gameData().parts.names().size());
    EXPECT_TRUE(player.session().placed().empty()) << "each level keeps its own";
    ASSERT_TRUE(player.session().place({"iron ball", {0, 2}, 0, ""}));
    player.app().showTitle();
    player.frames(3);
    player.clickItem("free play");
    ASSERT_NE(player.findPlay(), nullptr);
    EXPECT_EQ(player.session().placed().size(), 1U);
}

TEST(Stars, AnotherKindOfSolutionHasOne) {
    Player player;
    auto const level = levelsFolder() / "first/1-first-contact.json";
    auto const stars = [&] {
        player.app().context().kinds.wait();
        player.frames(2);
        return player.app().context().profile.progress().of("first/1-first-contact.json").stars();
    };
    for (std::string const part : {"steel bar", "steel bar", "spanner"}) {
        player.open(level);
        ASSERT_TRUE(player.session().place({part, {-1.8, 1.3}, 0, ""}));
        player.key(SDLK_SPACE);
        player.simulate(400);
        ASSERT_TRUE(player.session().solved());
        EXPECT_EQ(stars(), part == "spanner" ? 2 : 1);
    }
    // It is the only puzzle of these chapters besides the puzzles that are not solved yet.
    for (CatalogGroup const& chapter : player.app().context().levels.groups()) {
        for (CatalogEntry const& entry : chapter.levels) {
            player.app().context().profile.markSolved(entry.id);
        }
    }
    player.frames(2);
    player.clickItem("next level");
    player.frames(3);
    EXPECT_EQ(player.app().menu().page(), MenuPage::ending);
    EXPECT_TRUE(player.showsCard("ending"));
}

TEST(Stars, AThirdOfOneLevelIsNotTheSecondOfAnother) {
    LevelCatalog const& levels = gameLevels();
    CampaignProgress progress;
    int puzzles = 0;
    int galleries = 0;
    for (CatalogGroup const& chapter : levels.groups()) {
        for (CatalogEntry const& entry : chapter.levels) {
            // Three kinds of solution are found for the first puzzle, one for the second, and two for every
            // other.
            int const kinds = chapter.gallery ? 3 : puzzles == 0 ? 3 : puzzles == 1 ? 1 : 2;
            (chapter.gallery ? galleries : puzzles) += 1;
            progress.markSolved(entry.id);
            for (int kind = 0; kind < kinds; ++kind) {
                progress.addKind(entry.id, {{std::string(1, static_cast<char>('a' + kind))}, {}, {}});
            }
        }
    }
    ASSERT_GT(puzzles, 2);
    ASSERT_GT(galleries, 0);
    StarCount const stars = levels.stars(progress);
    EXPECT_EQ(stars.won, 2 * puzzles);
    EXPECT_EQ(stars.missing, 1) << "the second star of the second puzzle";
    EXPECT_EQ(levels.stars({}).missing, 2 * puzzles);
    EXPECT_EQ(levels.stars({}).won, 0);
}

} // namespace
} // namespace trembler::ui::test
