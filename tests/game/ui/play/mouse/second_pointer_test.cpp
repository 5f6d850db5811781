// Two players: the second one has a gamepad and a pointer of their own.
#include "runtime/placement.hpp"
#include "tests/game/ui/virtual_pad.hpp"

namespace trembler::ui::test {
namespace second_pointer_test {
namespace {

auto const experimentOne = levelsFolder() / "experiments/1-switched-electromagnet.json";

Vec2 leverOf(Player& player) {
    World const& world = player.session().world();
    return world.find<Position>(world.store().find("switch"))->value;
}

/// With the second pointer.
void goTo(Player& player, VirtualPad const& pad, Vec2 to) {
    pad.leadSecondPointer(player, to);
    EXPECT_LT(length(player.play().secondPointer().at() - to), 0.2);
}

/// Holds the lever with the second hand, and lets it go.
void useSecondHand(Player& player, VirtualPad const& pad) {
    goTo(player, pad, leverOf(player));
    player.look("second-player-720");
    pad.hold(player, SDL_CONTROLLER_BUTTON_A, true);
    player.frames(25);
    ObjectId const lever = player.session().world().store().find("switch");
    EXPECT_EQ(player.play().secondHand().held(), lever);
    EXPECT_FALSE(player.play().hand().held().valid()) << "the first player's hand is empty";
    Vec2 const before = leverOf(player);
    pad.lean(player, SDL_CONTROLLER_AXIS_LEFTY, -32000);
    player.frames(40);
    pad.lean(player, SDL_CONTROLLER_AXIS_LEFTY, 0);
    EXPECT_GT(leverOf(player).y, before.y + 0.2) << "it is lifted";
    player.look("second-player-lifts-720");
    pad.hold(player, SDL_CONTROLLER_BUTTON_A, false);
    player.frames(2);
    EXPECT_FALSE(player.play().secondHand().held().valid());
    auto const inputs = player.session().inputs();
    ASSERT_FALSE(inputs.empty());
    EXPECT_TRUE(std::all_of(inputs.begin(), inputs.end(), [](auto const& input) { return input.hand == 1; }));
}

TEST(SecondPlayer, MovesGrabsAndLetsGoWithASecondGamepad) {
    Player player;
    VirtualPad const first;
    VirtualPad const second;
    if (!first.works() || !second.works()) {
        GTEST_SKIP() << "SDL has no virtual gamepads here: " << SDL_GetError();
    }
    player.open(experimentOne);
    player.frames(2);
    ASSERT_EQ(player.app().context().pads.count(), 2U);
    first.press(player, SDL_CONTROLLER_BUTTON_X); // the first player starts the run
    ASSERT_NE(player.session().mode(), SessionMode::building);
    player.simulate(60);
    EXPECT_TRUE(player.play().secondPointer().active());
    EXPECT_FALSE(player.play().keyPointer().active()) << "the second gamepad does not move the first pointer";
    useSecondHand(player, second);
}

TEST(SecondPlayer, MayHaveTheOnlyGamepadIfTheSettingsSaySo) {
    Player player;
    VirtualPad const pad;
    if (!pad.works()) {
        GTEST_SKIP() << "SDL has no virtual gamepads here: " << SDL_GetError();
    }
    player.open(experimentOne);
    player.frames(2);
    EXPECT_FALSE(player.play().secondPointer().active());
    player.app().context().profile.setSettings({.volume = 0, .padIsSecond = true});
    player.frames(2);
    EXPECT_TRUE(player.play().secondPointer().active());
    player.key(SDLK_SPACE);
    player.simulate(60);
    useSecondHand(player, pad);
}

TEST(OneGamepad, WinsTheFirstLevel) {
    Player player;
    VirtualPad const pad;
    if (!pad.works()) {
        GTEST_SKIP() << "this SDL has no virtual gamepads";
    }
    player.open(levelsFolder() / "first/1-first-contact.json");
    pad.push(player, SDL_CONTROLLER_AXIS_TRIGGERRIGHT, 32000);
    ASSERT_TRUE(player.play().placing().carried());
    auto const at = [&] { return player.play().keyPointer().at(); };
    pad.press(player, SDL_CONTROLLER_BUTTON_DPAD_LEFT); // the pointer appears
    Vec2 const there{-1.8, 1.2};
    for (int i = 0; i < 200 && std::abs(at().x - there.x) > gridStep / 2; ++i) {
        pad.press(player,
                  at().x > there.x ? SDL_CONTROLLER_BUTTON_DPAD_LEFT : SDL_CONTROLLER_BUTTON_DPAD_RIGHT);
    }
    for (int i = 0; i < 200 && std::abs(at().y - there.y) > gridStep / 2; ++i) {
        pad.press(player, at().y > there.y ? SDL_CONTROLLER_BUTTON_DPAD_DOWN : SDL_CONTROLLER_BUTTON_DPAD_UP);
    }
    pad.press(player, SDL_CONTROLLER_BUTTON_A);
    ASSERT_EQ(player.session().placed().size(), 1U);
    pad.press(player, SDL_CONTROLLER_BUTTON_X);
    player.simulate(600);
    EXPECT_TRUE(player.session().solved());
}

TEST(OneGamepad, ReachesSpeedWiresGroupsAndFlipping) {
    Player player;
    VirtualPad const pad;
    if (!pad.works()) {
        GTEST_SKIP() << "SDL has no virtual gamepads here: " << SDL_GetError();
    }
    player.open(dataFolder() / "wires.json");
    ASSERT_TRUE(player.session().place({"steel bar", {-1.5, 2.5}, 0, ""}));
    ASSERT_TRUE(player.session().place({"wooden bar", {1.5, 2.5}, 0, ""}));
    player.play().worldChanged();
    pad.push(player, SDL_CONTROLLER_AXIS_RIGHTX, -30000);
    EXPECT_TRUE(player.play().wires().laying());
    pad.press(player, SDL_CONTROLLER_BUTTON_B);
    EXPECT_FALSE(player.play().wires().laying());
    for (Vec2 const at : {Vec2{-1.5, 2.5}, Vec2{1.5, 2.5}}) {
        player.moveTo(player.at(at)); // the pointer of the keys begins where the mouse is
        pad.press(player, SDL_CONTROLLER_BUTTON_DPAD_UP);
        pad.press(player, SDL_CONTROLLER_BUTTON_DPAD_DOWN);
        pad.push(player, SDL_CONTROLLER_AXIS_RIGHTY, 30000);
    }
    EXPECT_EQ(player.play().group().chosen().size(), 2U);
    pad.push(player, SDL_CONTROLLER_AXIS_RIGHTY, -30000);
    ASSERT_EQ(player.session().placed().size(), 2U);
    EXPECT_TRUE(player.session().placed()[0].placement.flipped);
    pad.press(player, SDL_CONTROLLER_BUTTON_LEFTSHOULDER);
    EXPECT_FALSE(player.session().placed()[0].placement.flipped) << "while building L1 undoes";
    pad.press(player, SDL_CONTROLLER_BUTTON_X);
    double const speed = player.play().speed().now();
    pad.press(player, SDL_CONTROLLER_BUTTON_LEFTSHOULDER);
    EXPECT_LT(player.play().speed().now(), speed) << "in a run it makes it slower";
    pad.press(player, SDL_CONTROLLER_BUTTON_RIGHTSHOULDER);
    pad.press(player, SDL_CONTROLLER_BUTTON_RIGHTSHOULDER);
    EXPECT_GT(player.play().speed().now(), speed);
    pad.push(player, SDL_CONTROLLER_AXIS_TRIGGERLEFT, 30000);
    EXPECT_TRUE(player.play().hand().cutting());
}

} // namespace
} // namespace second_pointer_test
} // namespace trembler::ui::test
