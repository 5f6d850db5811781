// The second player's gamepad: which of its buttons move the hand, and how far.
#include "render/window/gamepad.hpp"
#include "render/window/second_pad.hpp"

#include <gtest/gtest.h>

namespace trembler::render::test {
namespace second_pad_test {
namespace {

SDL_Event buttonEvent(SDL_JoystickID pad, SDL_GameControllerButton button, bool down) {
    SDL_Event event{};
    event.type = down ? SDL_CONTROLLERBUTTONDOWN : SDL_CONTROLLERBUTTONUP;
    event.cbutton.which = pad;
    event.cbutton.button = static_cast<Uint8>(button);
    return event;
}

TEST(SecondPadState, MovesByThePadAndByTheStickAtTheSameTime) {
    SecondPadState state;
    SDL_Keycode const left = padKey(SDL_CONTROLLER_BUTTON_DPAD_LEFT);
    SDL_Keycode const up = padKey(SDL_CONTROLLER_BUTTON_DPAD_UP);
    EXPECT_TRUE(state.moves(left));
    EXPECT_FALSE(state.moves(padKey(SDL_CONTROLLER_BUTTON_X)));
    state.take({.key = left, .way = 0.5, .axis = true});
    EXPECT_DOUBLE_EQ(state.now().x, -0.5);
    state.take({.key = left, .way = 1});
    EXPECT_DOUBLE_EQ(state.now().x, -1);
    state.take({.key = left, .way = 0});
    EXPECT_DOUBLE_EQ(state.now().x, -0.5) << "the stick still leans";
    state.take({.key = left, .way = 0.1, .axis = true});
    EXPECT_DOUBLE_EQ(state.now().x, 0) << "a stick that is let go does not tremble";
    state.take({.key = up, .way = 1});
    EXPECT_DOUBLE_EQ(state.now().y, 1);
    state.letGo();
    EXPECT_DOUBLE_EQ(state.now().y, 0);
}

TEST(SecondPadState, GrabsWithATriggerThatPassesHalfOfItsWay) {
    SecondPadState state;
    SecondPadButtons buttons;
    buttons.grab = {padRightTrigger};
    state.setButtons(buttons);
    EXPECT_FALSE(state.moves(padKey(SDL_CONTROLLER_BUTTON_A)));
    auto const grabsAt = [&](double way) {
        state.take({.key = padRightTrigger, .way = way, .axis = true});
        return state.now().grabs;
    };
    EXPECT_FALSE(grabsAt(0.4));
    EXPECT_TRUE(grabsAt(0.6));
    EXPECT_TRUE(grabsAt(0.4)) << "still held";
    EXPECT_FALSE(grabsAt(0.3));
    EXPECT_TRUE(grabsAt(1));
    state.setButtons(buttons);
    EXPECT_TRUE(state.now().grabs) << "nothing has changed";
    state.setButtons({});
    EXPECT_FALSE(state.now().grabs) << "it has another meaning now";
}

TEST(Gamepad, AKeyIsHeldUntilEveryGamepadLetsItGo) {
    Gamepads pads;
    EXPECT_EQ(pads.take(buttonEvent(1, SDL_CONTROLLER_BUTTON_X, true)).size(), 1U);
    EXPECT_TRUE(pads.take(buttonEvent(2, SDL_CONTROLLER_BUTTON_X, true)).empty());
    EXPECT_TRUE(pads.take(buttonEvent(1, SDL_CONTROLLER_BUTTON_X, false)).empty());
    auto const last = pads.take(buttonEvent(2, SDL_CONTROLLER_BUTTON_X, false));
    ASSERT_EQ(last.size(), 1U);
    EXPECT_EQ(last[0].type, static_cast<Uint32>(SDL_KEYUP));
}

} // namespace
} // namespace second_pad_test
} // namespace trembler::render::test
