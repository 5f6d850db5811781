// Keys as pages, the keyboard on the screen and ImGui's widgets read them, with other keys than the usual
// ones.
#include "game/ui/app/command_lists.hpp"
#include "game/ui/shared/commands/menu_keys.hpp"
#include "render/window/gamepad.hpp"
#include "tests/game/ui/shared/commands/counting_screen.hpp"

#include <gtest/gtest.h>

namespace trembler::ui::test {
namespace {

using render::padKey;

SDL_Event keyUp(SDL_Keycode key) {
    SDL_Event event = keyDown(key);
    event.type = SDL_KEYUP;
    return event;
}

std::optional<MenuKey> meaning(SDL_Keycode key, KeyBindings const& bindings, int modifiers = KMOD_NONE,
                               bool typing = false) {
    MenuKeys keys;
    std::vector<SDL_Event> const events{keyDown(key, modifiers)};
    keys.read(events, bindings, typing);
    return keys.presses().empty() ? std::nullopt : std::optional(keys.presses().front().key);
}

/// The bindings of the program with other keys.
KeyBindings changed(StatedKeys const& stated) {
    KeyBindings bindings(commandLists());
    auto const troubles = bindings.load(stated);
    EXPECT_TRUE(troubles.empty()) << (troubles.empty() ? "" : troubles.front());
    return bindings;
}

TEST(MenuKeys, HaveTheirUsualMeaning) {
    KeyBindings const usual(commandLists());
    EXPECT_EQ(meaning(SDLK_DOWN, usual), MenuKey::down);
    EXPECT_EQ(meaning(SDLK_KP_ENTER, usual), MenuKey::press);
    EXPECT_EQ(meaning(SDLK_SPACE, usual), MenuKey::press);
    EXPECT_EQ(meaning(SDLK_TAB, usual), MenuKey::next);
    EXPECT_EQ(meaning(SDLK_TAB, usual, KMOD_LSHIFT), MenuKey::before);
    EXPECT_EQ(meaning(SDLK_ESCAPE, usual, KMOD_LCTRL), MenuKey::back);
    EXPECT_EQ(meaning(padKey(SDL_CONTROLLER_BUTTON_A), usual), MenuKey::press);
    EXPECT_EQ(meaning(padKey(SDL_CONTROLLER_BUTTON_LEFTSHOULDER), usual), MenuKey::pageBefore);
    EXPECT_EQ(meaning(SDLK_k, usual), std::nullopt);
}

TEST(MenuKeys, AreThoseThatThePlayerChose) {
    KeyBindings const bindings =
        changed({{"menu-down", {"K", "Pad Left stick"}}, {"back", {"\\", "Pad Guide"}}});
    EXPECT_EQ(meaning(SDLK_k, bindings), MenuKey::down);
    EXPECT_EQ(meaning(padKey(SDL_CONTROLLER_BUTTON_LEFTSTICK), bindings), MenuKey::down);
    EXPECT_EQ(meaning(SDLK_DOWN, bindings), std::nullopt);
    EXPECT_EQ(meaning(SDLK_BACKSLASH, bindings, KMOD_LSHIFT), MenuKey::back);
    EXPECT_EQ(meaning(SDLK_ESCAPE, bindings), std::nullopt);
}

TEST(MenuKeys, AFieldKeepsTheKeysThatWrite) {
    KeyBindings const bindings =
        changed({{"menu-down", {"K", "Pad Left stick"}}, {"menu-up", {"F5", "Pad Up"}}});
    EXPECT_EQ(meaning(SDLK_k, bindings, KMOD_NONE, true), std::nullopt);
    EXPECT_EQ(meaning(SDLK_SPACE, bindings, KMOD_NONE, true), std::nullopt);
    EXPECT_EQ(meaning(SDLK_KP_1, bindings, KMOD_NONE, true), std::nullopt);
    EXPECT_EQ(meaning(SDLK_F5, bindings, KMOD_NONE, true), MenuKey::up);
    EXPECT_EQ(meaning(SDLK_DOWN, bindings, KMOD_NONE, true), MenuKey::down) << "the list below a field";
    EXPECT_EQ(meaning(SDLK_RETURN, bindings, KMOD_NONE, true), MenuKey::press);
}

TEST(MenuKeys, WidgetsReadThemAsTheirOwn) {
    KeyBindings const bindings =
        changed({{"menu-down", {"K", "Pad Left stick"}}, {"menu-press", {"P", "Pad Right stick"}}});
    WidgetKeys widgets;
    auto const shown = [&](SDL_Event const& event, bool typing = false) {
        SDL_Event const read = widgets.read(event, bindings, typing);
        if (read.key.keysym.sym != event.key.keysym.sym) {
            EXPECT_EQ(read.key.keysym.scancode, SDL_GetScancodeFromKey(read.key.keysym.sym));
        }
        return read.key.keysym.sym;
    };
    EXPECT_EQ(shown(keyDown(SDLK_k)), SDLK_DOWN);
    EXPECT_EQ(shown(keyUp(SDLK_k), true), SDLK_DOWN) << "as it went down";
    EXPECT_EQ(shown(keyDown(SDLK_k), true), SDLK_k) << "a letter of a field";
    EXPECT_EQ(shown(keyUp(SDLK_k)), SDLK_k);
    EXPECT_EQ(shown(keyDown(SDLK_p)), SDLK_SPACE);
    EXPECT_EQ(shown(keyDown(padKey(SDL_CONTROLLER_BUTTON_RIGHTSTICK))), SDLK_SPACE);
    EXPECT_EQ(shown(keyDown(padKey(SDL_CONTROLLER_BUTTON_X))), SDLK_RETURN);
    EXPECT_EQ(shown(keyDown(SDLK_DOWN)), SDLK_UNKNOWN);
    EXPECT_EQ(shown(keyDown(SDLK_SPACE)), SDLK_UNKNOWN);
    EXPECT_EQ(shown(keyDown(SDLK_a)), SDLK_a);
}

TEST(MenuKeys, TheKeyboardOnTheScreenFindsItsButtons) {
    KeyBindings const bindings = changed({{"letters-erase", {"Pad Back"}}});
    EXPECT_EQ(letterButtonOf(padKey(SDL_CONTROLLER_BUTTON_BACK), bindings), padKey(SDL_CONTROLLER_BUTTON_X));
    EXPECT_EQ(letterButtonOf(padKey(SDL_CONTROLLER_BUTTON_X), bindings), 0);
    EXPECT_EQ(letterButtonOf(padKey(SDL_CONTROLLER_BUTTON_A), bindings), padKey(SDL_CONTROLLER_BUTTON_A));
}

} // namespace
} // namespace trembler::ui::test
