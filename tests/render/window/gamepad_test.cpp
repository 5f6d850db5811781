// Buttons of gamepads as keys.
#include "render/window/gamepad.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace trembler::render::test {
namespace {

SDL_Event axisMoved(SDL_GameControllerAxis axis, Sint16 value) {
    SDL_Event event{};
    event.type = SDL_CONTROLLERAXISMOTION;
    event.caxis.axis = static_cast<Uint8>(axis);
    event.caxis.value = value;
    return event;
}

TEST(Gamepad, ButtonsHaveNamesThatAreNoKeys) {
    for (SDL_Keycode key = firstPadKey; key <= padRightStickDown; ++key) {
        std::string_view const name = nameOfPadKey(key);
        if (!name.empty()) {
            EXPECT_EQ(padKeyFrom(name), key) << name;
        }
    }
    EXPECT_EQ(nameOfPadKey(padKey(SDL_CONTROLLER_BUTTON_A)), "Pad A");
    EXPECT_EQ(padKeyFrom("pad r1"), padKey(SDL_CONTROLLER_BUTTON_RIGHTSHOULDER));
    EXPECT_FALSE(padKeyFrom("A"));
    EXPECT_FALSE(padKeyFrom(""));
    EXPECT_TRUE(nameOfPadKey(SDLK_a).empty());
    EXPECT_FALSE(isPadKey(SDLK_RCTRL));
    EXPECT_FALSE(isPadKey(SDLK_F12));
}

TEST(Gamepad, TheStickIsADirectionalPadThatDoesNotTremble) {
    Gamepads pads;
    EXPECT_TRUE(pads.take(axisMoved(SDL_CONTROLLER_AXIS_LEFTX, 9000)).empty());
    auto const right = pads.take(axisMoved(SDL_CONTROLLER_AXIS_LEFTX, 20000));
    ASSERT_EQ(right.size(), 1U);
    EXPECT_EQ(right[0].type, static_cast<Uint32>(SDL_KEYDOWN));
    EXPECT_EQ(right[0].key.keysym.sym, padKey(SDL_CONTROLLER_BUTTON_DPAD_RIGHT));
    EXPECT_TRUE(pads.take(axisMoved(SDL_CONTROLLER_AXIS_LEFTX, 15000)).empty()) << "still held";
    auto const left = pads.take(axisMoved(SDL_CONTROLLER_AXIS_LEFTX, -32768));
    ASSERT_EQ(left.size(), 2U) << "one is let go, the other pressed";
    EXPECT_EQ(pads.take(axisMoved(SDL_CONTROLLER_AXIS_LEFTX, 0)).size(), 1U);
    EXPECT_EQ(pads.take(axisMoved(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, 32767)).size(), 1U);
    EXPECT_EQ(pads.count(), 0U);
}

} // namespace
} // namespace trembler::render::test
