// The program holds one screen of any type; menus over it can be used with the keyboard alone.
#include "tests/game/ui/player.hpp"

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
    player.key(SDLK_DOWN); // the focus moves to the first level
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
    player.key(SDLK_UP); // wraps to "Quit"
    player.key(SDLK_UP); // "Title screen"
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
    for (int i = 0; i < 3; ++i) {
        player.key(SDLK_DOWN); // resume, again, levels, settings
    }
    player.key(SDLK_RETURN);
    player.frames(2);
    ASSERT_EQ(player.app().menu().page(), MenuPage::settings);
    for (int i = 0; i < 7; ++i) {
        player.key(SDLK_DOWN); // six sizes, shadows, volume
    }
    player.key(SDLK_RIGHT);
    player.key(SDLK_RIGHT);
    player.key(SDLK_LEFT);
    EXPECT_EQ(player.app().context().profile.settings().volume, 55);
    for (int i = 0; i < 3; ++i) {
        player.key(SDLK_DOWN); // headphones, full screen, the keys
    }
    player.moveTo({640, 20});
    player.moveTo({645, 20}); // the mouse removes the focus, so Enter presses nothing
    player.key(SDLK_RETURN);
    EXPECT_EQ(player.app().menu().page(), MenuPage::settings);
}

} // namespace
} // namespace trembler::ui::test
