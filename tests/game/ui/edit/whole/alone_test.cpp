// A level made, test-played, saved, left and opened again, by a gamepad alone and by the keyboard alone.
#include "tests/game/ui/edit/editor_kit.hpp"
#include "tests/game/ui/shared/letters/pad_typist.hpp"

#include <functional>

namespace trembler::ui::test {
namespace alone_test {
namespace {

/// What the hands of a designer can do, with one kind of device.
struct Hands {
    std::function<void()> up, down, left, right, press, back, menu, panel, next, play;
    std::function<void(char const* id)> command;
    std::function<void(std::string const& text)> type; ///< into the field that has the keys; ends the typing
};

Hands keyboardOf(Designer& designer) {
    auto const key = [&designer](SDL_Keycode code, unsigned modifiers = KMOD_NONE) {
        return [&designer, code, modifiers] {
            designer.key(code, modifiers);
            designer.frames(2);
        };
    };
    return {.up = key(SDLK_UP),
            .down = key(SDLK_DOWN),
            .left = key(SDLK_LEFT),
            .right = key(SDLK_RIGHT),
            .press = key(SDLK_RETURN),
            .back = key(SDLK_ESCAPE),
            .menu = key(SDLK_F10),
            .panel = key(SDLK_F9),
            .next = key(SDLK_TAB),
            .play = key(SDLK_SPACE),
            .command =
                [&designer](char const* id) {
                    auto const keys = designer.app().context().keys.keysOf(id);
                    ASSERT_FALSE(keys.empty()) << id;
                    designer.key(keys.front().key, (keys.front().ctrl ? KMOD_LCTRL : KMOD_NONE) |
                                                       (keys.front().shift ? KMOD_LSHIFT : KMOD_NONE));
                    designer.frames(2);
                },
            .type =
                [&designer](std::string const& text) {
                    designer.ctrl(SDLK_a);
                    designer.typeText(text);
                    designer.frames(1);
                    designer.key(SDLK_RETURN);
                    designer.frames(3);
                }};
}

/// Opens the list of all commands, goes down to one and presses.
void choose(Designer& designer, VirtualPad const& pad, char const* id) {
    pad.press(designer, SDL_CONTROLLER_BUTTON_A);
    ASSERT_TRUE(designer.showsCard("command palette"));
    CommandSet const& commands = designer.screen().commands();
    for (std::size_t i = 0; commands.info(i).id != id; ++i) {
        if (commands.available(i) && !commands.info(i).leads) {
            pad.press(designer, SDL_CONTROLLER_BUTTON_DPAD_DOWN);
        }
    }
    pad.press(designer, SDL_CONTROLLER_BUTTON_A);
    designer.frames(2);
}

Hands gamepadOf(Designer& designer, VirtualPad const& pad) {
    auto const button = [&](SDL_GameControllerButton which) {
        return [&designer, &pad, which] { pad.press(designer, which); };
    };
    return {.up = button(SDL_CONTROLLER_BUTTON_DPAD_UP),
            .down = button(SDL_CONTROLLER_BUTTON_DPAD_DOWN),
            .left = button(SDL_CONTROLLER_BUTTON_DPAD_LEFT),
            .right = button(SDL_CONTROLLER_BUTTON_DPAD_RIGHT),
            .press = button(SDL_CONTROLLER_BUTTON_A),
            .back = button(SDL_CONTROLLER_BUTTON_B),
            .menu = button(SDL_CONTROLLER_BUTTON_START),
            .panel = button(SDL_CONTROLLER_BUTTON_LEFTSTICK),
            .next = button(SDL_CONTROLLER_BUTTON_RIGHTSHOULDER),
            .play = button(SDL_CONTROLLER_BUTTON_X),
            .command = [&](char const* id) { choose(designer, pad, id); },
            .type =
                [&](std::string const& text) {
                    PadTypist typist(designer, pad);
                    ASSERT_TRUE(typist.keyboard().open()) << "the keyboard on the screen";
                    typist.type(text);
                    typist.pressKey(KeyAct::done);
                    designer.frames(3);
                }};
}

bool inEditor(Designer& designer) {
    return dynamic_cast<EditScreen*>(&designer.app().screen()) != nullptr;
}

/// From the title into the editor: play, levels, gallery, free play, editor.
void enterEditor(Designer& designer, Hands const& hands) {
    for (int i = 0; i < 4; ++i) {
        hands.down();
    }
    hands.press();
    designer.frames(4);
    ASSERT_TRUE(inEditor(designer));
}

void makeLevel(Designer& designer, Hands const& hands) {
    std::size_t const before = designer.count("objects");
    hands.panel();
    for (int i = 0; i < 3; ++i) {
        hands.down();
    }
    hands.press();
    hands.up(); // "anvil", which can move
    hands.press();
    hands.back();
    ASSERT_EQ(designer.count("objects"), before + 2) << "two parts of the catalogue";
    ASSERT_EQ(designer.parts().selected().size(), 1U);
    std::string const part = designer.parts().selected().front();
    Vec2 const place = designer.placeOf(part);
    for (int i = 0; i < 20; ++i) { // beside the first one
        hands.right();
    }
    EXPECT_NEAR(designer.placeOf(part).x, place.x + 1, 1e-9);
    hands.command("edit-placing");
    hands.command("edit-placing"); // a second time: in the middle
    EXPECT_EQ(designer.count("placing"), 1U);
    for (int i = 0; i < 10 && designer.parts().selected() != std::vector{part}; ++i) {
        hands.next();
    }
    ASSERT_EQ(designer.parts().selected(), std::vector{part});
    hands.command("edit-goal-area");
    hands.command("edit-goal-area");
    ASSERT_TRUE(designer.tree().contains("goals"));
    EXPECT_EQ(designer.tree()["goals"]["inside"]["object"], part) << designer.tree()["goals"];
}

void makeAndReopen(Designer& designer, Hands const& hands, std::string const& name) {
    std::filesystem::path const folder = testFolder() / "alone";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    std::filesystem::path const before = std::filesystem::current_path();
    std::filesystem::current_path(folder);
    hands.down(); // the ring appears
    enterEditor(designer, hands);
    makeLevel(designer, hands);
    hands.play();
    designer.frames(2);
    ASSERT_NE(designer.screen().test(), nullptr) << designer.tree();
    hands.back();
    designer.frames(2);
    ASSERT_EQ(designer.screen().test(), nullptr);
    designer.look("edit-alone-" + name);
    hands.command("edit-save");
    ASSERT_TRUE(designer.showsCard("file browser"));
    hands.type(name);
    std::filesystem::path const file = folder / (name + ".json");
    ASSERT_TRUE(std::filesystem::exists(file));
    EXPECT_FALSE(designer.parts().document.modified());
    edit::Json const saved = designer.tree();
    hands.menu();
    designer.frames(2);
    ASSERT_TRUE(designer.app().menu().isOpen());
    hands.up();   // around to the last row
    hands.left(); // "Title screen"
    hands.press();
    designer.frames(3);
    ASSERT_FALSE(inEditor(designer));
    enterEditor(designer, hands);
    hands.command("edit-open");
    ASSERT_TRUE(designer.showsCard("file browser"));
    hands.down(); // from ".." to the only file
    designer.look("edit-alone-open-" + name);
    hands.press();
    designer.frames(4);
    EXPECT_EQ(designer.parts().document.path(), file);
    EXPECT_EQ(designer.tree(), saved);
    std::filesystem::current_path(before);
}

TEST(EditorAlone, ByKeyboard) {
    Designer designer;
    makeAndReopen(designer, keyboardOf(designer), "keys");
}

TEST(EditorAlone, ByGamepad) {
    Designer designer;
    VirtualPad const pad;
    if (!pad.works()) {
        GTEST_SKIP() << "SDL has no virtual gamepads here: " << SDL_GetError();
    }
    designer.frames(2);
    makeAndReopen(designer, gamepadOf(designer, pad), "pad");
}

} // namespace
} // namespace alone_test
} // namespace trembler::ui::test
