// The view is moved and zoomed without a mouse: by keys, and by a gamepad.
#include "game/ui/edit/edit_screen.hpp"
#include "tests/game/ui/virtual_pad.hpp"

namespace trembler::ui::test {
namespace play_screen_view_test {
namespace {

auto const firstContact = levelsFolder() / "first/1-first-contact.json";

class View : public testing::Test {
protected:
    View() { player.open(firstContact); }
    [[nodiscard]] Point centre() { return player.play().camera().centre; }
    [[nodiscard]] double scale() { return player.play().camera().pixelsPerMetre; }
    /// A trigger's axis rests at its lowest value.
    void pull(VirtualPad const& pad, SDL_GameControllerAxis trigger) {
        pad.lean(player, trigger, 32767);
        pad.lean(player, trigger, -32768);
        player.frames(2);
    }
    Player player;
};

TEST_F(View, IsMovedByKeysWhileBuildingAndInARun) {
    for (bool const runs : {false, true}) {
        if (runs) {
            player.key(SDLK_SPACE);
            player.key(SDLK_p);
        }
        player.key(SDLK_HOME);
        Point const start = centre();
        double const window = 1280 / scale();
        player.key(SDLK_RIGHT, KMOD_LCTRL);
        EXPECT_NEAR(centre().x, start.x + 0.1 * window, 1e-6);
        player.key(SDLK_UP, KMOD_LCTRL);
        EXPECT_NEAR(centre().y, start.y + 0.1 * window * 720 / 1280, 1e-6);
        player.key(SDLK_LEFT, KMOD_LCTRL);
        player.key(SDLK_DOWN, KMOD_LCTRL);
        EXPECT_NEAR(centre().x, start.x, 1e-6);
        EXPECT_NEAR(centre().y, start.y, 1e-6);
        player.key(SDLK_EQUALS, KMOD_LCTRL);
        EXPECT_GT(scale(), 1.2 * 1280 / window);
        player.key(SDLK_MINUS, KMOD_LCTRL);
        EXPECT_NEAR(scale(), 1280 / window, 1e-6);
        player.key(SDLK_MINUS, KMOD_LCTRL);
        EXPECT_LT(scale(), 1280 / window);
        player.key(SDLK_HOME);
        EXPECT_NEAR(centre().x, start.x, 1e-6);
    }
}

TEST_F(View, IsMovedByAGamepadUntilBEndsIt) {
    VirtualPad const pad;
    ASSERT_TRUE(pad.works());
    player.frames(2);
    player.play().commands().run("move-view"); // as from the menu, under "All commands"
    player.frames(2);
    Point const start = centre();
    double const before = scale();
    pad.press(player, SDL_CONTROLLER_BUTTON_DPAD_RIGHT);
    EXPECT_GT(centre().x, start.x);
    pad.hold(player, SDL_CONTROLLER_BUTTON_DPAD_DOWN, true);
    Point const pressed = centre();
    player.frames(60);
    pad.hold(player, SDL_CONTROLLER_BUTTON_DPAD_DOWN, false);
    EXPECT_LT(centre().y, pressed.y - 0.2 * 720 / before) << "it moves on while it is held";
    pull(pad, SDL_CONTROLLER_AXIS_TRIGGERRIGHT);
    EXPECT_GT(scale(), before);
    pull(pad, SDL_CONTROLLER_AXIS_TRIGGERLEFT);
    EXPECT_NEAR(scale(), before, 1e-6);
    EXPECT_FALSE(player.play().placing().carried()) << "no trigger took a part";
    pad.press(player, SDL_CONTROLLER_BUTTON_B);
    EXPECT_FALSE(player.app().menu().isOpen()) << "B only ends it";
    Point const ended = centre();
    pad.press(player, SDL_CONTROLLER_BUTTON_DPAD_RIGHT);
    EXPECT_EQ(centre().x, ended.x) << "the directional pad moves the pointer again";
    pull(pad, SDL_CONTROLLER_AXIS_TRIGGERRIGHT);
    EXPECT_TRUE(player.play().placing().carried()) << "and the trigger takes a part";
}

TEST(EditorView, IsMovedByKeys) {
    Player player;
    player.app().edit(firstContact);
    player.frames(4);
    auto& screen = dynamic_cast<EditScreen&>(player.app().screen());
    Point const start = screen.parts().camera().centre;
    player.key(SDLK_LEFT, KMOD_LCTRL);
    player.key(SDLK_UP, KMOD_LCTRL);
    EXPECT_LT(screen.parts().camera().centre.x, start.x);
    EXPECT_GT(screen.parts().camera().centre.y, start.y);
    EXPECT_TRUE(screen.parts().selected().empty());
}

} // namespace
} // namespace play_screen_view_test
} // namespace trembler::ui::test
