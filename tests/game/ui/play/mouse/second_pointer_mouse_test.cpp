// The hands of two players at once: the first one's mouse and the second one's gamepad.
#include "runtime/placement.hpp"
#include "tests/game/ui/virtual_pad.hpp"

namespace trembler::ui::test {
namespace second_pointer_mouse_test {
namespace {

auto const laboratoryDoor = levelsFolder() / "5-everything/1-the-laboratory-door.json";

Vec2 doorOf(Player& player) {
    World const& world = player.session().world();
    return world.find<Position>(world.store().find("door"))->value;
}

/// With the second pointer.
void goTo(Player& player, VirtualPad const& pad, Vec2 to) {
    pad.leadSecondPointer(player, to);
    ASSERT_LT(length(player.play().secondPointer().at() - to), 0.1);
}

void pullByMouse(Player& player, ObjectId door) {
    player.moveTo(player.at(doorOf(player) + Vec2{0, 0.35}));
    player.press();
    player.moveTo(player.at(doorOf(player) + Vec2{0, 0.6}));
    ASSERT_EQ(player.play().hand().held(), door);
    player.moveTo(player.at({1.7, 2.2}));
    player.simulate(120);
}

void pullByGamepad(Player& player, VirtualPad const& pad, ObjectId door) {
    goTo(player, pad, doorOf(player) + Vec2{0, 0.1});
    pad.hold(player, SDL_CONTROLLER_BUTTON_A, true);
    player.frames(25);
    ASSERT_EQ(player.play().secondHand().held(), door);
    pad.lean(player, SDL_CONTROLLER_AXIS_LEFTY, -32000);
    player.frames(60);
    pad.lean(player, SDL_CONTROLLER_AXIS_LEFTY, 0);
    player.simulate(60);
}

// A hand pulls with 600 N there, and the magnet holds the door against one of them.
TEST(TwoPlayers, OpenTogetherWhatNeitherOpensAlone) {
    Player player;
    VirtualPad const pad;
    if (!pad.works()) {
        GTEST_SKIP() << "SDL has no virtual gamepads here: " << SDL_GetError();
    }
    player.open(laboratoryDoor);
    player.app().context().profile.setSettings({.volume = 0, .padIsSecond = true});
    player.frames(2);
    player.key(SDLK_SPACE);
    player.simulate(30);
    ObjectId const door = player.session().world().store().find("door");
    double const shut = doorOf(player).y;

    pullByGamepad(player, pad, door);
    EXPECT_LT(doorOf(player).y - shut, 0.1) << "the second player alone";
    pad.hold(player, SDL_CONTROLLER_BUTTON_A, false);
    player.frames(2);
    EXPECT_FALSE(player.play().secondHand().held().valid());

    pullByMouse(player, door);
    EXPECT_LT(doorOf(player).y - shut, 0.1) << "the first player alone";
    EXPECT_EQ(player.play().hand().held(), door) << "pulling on";

    pullByGamepad(player, pad, door);
    EXPECT_EQ(player.play().hand().held(), door);
    EXPECT_EQ(player.play().secondHand().held(), door);
    player.look("two-players-720");
    EXPECT_GT(doorOf(player).y - shut, 0.9) << "both together";
    player.simulate(300);
    EXPECT_TRUE(player.session().solved());
}

} // namespace
} // namespace second_pointer_mouse_test
} // namespace trembler::ui::test
