// An open list, a menu or a field that is edited has the keys: no key runs a command of the editor behind it.
#include "game/ui/edit/commands/edit_commands.hpp"
#include "game/ui/edit/edit_words.hpp"
#include "game/ui/edit/keys_owner.hpp"
#include "render/window/gamepad.hpp"
#include "tests/game/ui/edit/editor_kit.hpp"

#include <algorithm>
#include <array>
#include <functional>

namespace trembler::ui::test {
namespace keys_owner_test {
namespace {

char const* const room = R"({"version": 2, "title": "Room",
    "world": {"gravity": [0, -9.81], "bounds": [-4, -0.5, 8, 4.5]},
    "objects": [
        {"name": "floor", "at": [0, -0.15], "properties": {"material": "stone", "fixed": true,
         "shape": [{"form": "box", "width": 7.6, "height": 0.3}]}},
        {"name": "crate", "part": "crate", "at": [-1, 1]},
        {"name": "ball", "at": [1, 1], "properties": {"material": "wood",
         "shape": [{"form": "circle", "radius": 0.2}]}}],
    "editor": {"locked": ["floor"]}})";

/// Everything that a command could change.
struct State {
    std::string text;
    std::vector<std::string> selected;
    Tool tool;
    Tab tab;
    bool panelKeys, snaps, names, electricity, dialog, test, menu;
    double scale;
    Point looksAt;
    std::string clipboard;
    std::size_t toasts;

    bool operator==(State const&) const = default;
};

State stateOf(Designer& designer, bool withClipboard) {
    EditParts& parts = designer.parts();
    char* const copied = SDL_GetClipboardText();
    std::string clipboard = withClipboard ? copied : "";
    SDL_free(copied);
    return {parts.document.text(),
            parts.selected(),
            parts.tool,
            parts.tab,
            parts.panelKeys,
            parts.snapping.on,
            parts.names,
            parts.electricity,
            parts.dialogOpen(),
            parts.test != nullptr,
            designer.app().menu().isOpen(),
            parts.camera().pixelsPerMetre,
            parts.camera().centre,
            std::move(clipboard),
            designer.app().context().toasts.count()};
}

unsigned modifiersOf(Chord const& chord) {
    return (chord.ctrl ? KMOD_LCTRL : 0U) | (chord.shift ? KMOD_LSHIFT : 0U) | (chord.alt ? KMOD_LALT : 0U);
}

/// Every key, without a gamepad's, of every command of the editor.
std::vector<Chord> allKeys(Designer& designer) {
    std::vector<Chord> keys;
    for (Command<EditParts> const& command : editCommands()) {
        for (Chord const& chord : designer.app().context().keys.keysOf(command.info.id)) {
            if (chord.key != 0 && !render::isPadKey(chord.key)) {
                keys.push_back(chord);
            }
        }
    }
    return keys;
}

void begin(Designer& designer) {
    designer.parts().document.goTo(0);
    designer.parts().selection.set({"crate", "ball"});
    designer.parts().tool = Tool::select;
    designer.parts().tab = Tab::properties;
    designer.frames(2);
}

/// Something in the window that has the keys while it is open.
struct Owner {
    std::string name;
    std::function<void(Designer&)> open;
    std::function<bool(Designer&)> isOpen;
    bool copies = false; ///< it copies its own text
    std::function<void(Designer&)> close = [](Designer& designer) { designer.key(SDLK_ESCAPE); };
};

bool typing(Designer& designer) {
    return designer.app().context().gui.wantsKeyboard();
}
bool popupOpen(Designer&) {
    return KeysOwner::popup();
}
void click(Designer& designer, std::string const& item) {
    designer.clickItem(item);
    designer.frames(2);
}

std::vector<Owner> owners() {
    return {
        {"a list", [](Designer& d) { click(d, "object part"); }, popupOpen},
        {"a menu", [](Designer& d) { click(d, "menu " + std::string(words::menuArrange)); }, popupOpen},
        {"a number that is typed", [](Designer& d) { click(d, "at x"); }, typing, true},
        {"a text",
         [](Designer& d) {
             d.parts().selection.set({"crate"});
             d.frames(2);
             click(d, "object name");
         },
         typing, true},
        {"a number that is dragged",
         [](Designer& d) {
             d.moveTo(d.item("at x"));
             d.press();
         },
         [](Designer&) { return ImGui::IsAnyItemActive(); }, true,
         [](Designer& d) {
             d.release();
             d.key(SDLK_ESCAPE);
         }},
    };
}

/// Whether a widget may be left by the key, or its text be another one: later keys would keep that.
bool endsOrEdits(Chord const& chord) {
    constexpr std::array keys{SDLK_ESCAPE, SDLK_RETURN, SDLK_KP_ENTER, SDLK_SPACE,
                              SDLK_TAB,    SDLK_DELETE, SDLK_BACKSPACE};
    return std::find(keys.begin(), keys.end(), chord.key) != keys.end() ||
           (chord.ctrl && (chord.key == SDLK_x || chord.key == SDLK_v));
}

/// One of owners(), by its index.
class KeysOwnerOf : public testing::TestWithParam<std::size_t> {};

INSTANTIATE_TEST_SUITE_P(KeysOwner, KeysOwnerOf, testing::Range<std::size_t>(0, 5), [](auto const& info) {
    std::string name = owners().at(info.param).name;
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
});

TEST_P(KeysOwnerOf, LetsNoKeyRunACommand) {
    ASSERT_EQ(owners().size(), 5U);
    Owner const owner = owners().at(GetParam());
    Designer designer;
    designer.editText(room);
    std::vector<Chord> const keys = allKeys(designer);
    ASSERT_GT(keys.size(), 60U);
    begin(designer);
    for (Chord const& chord : keys) {
        if (!owner.isOpen(designer)) {
            begin(designer);
            owner.open(designer);
            ASSERT_TRUE(owner.isOpen(designer));
        }
        SDL_SetClipboardText("nothing");
        State const before = stateOf(designer, !owner.copies);
        render::pushKey(window(), chord.key, true, modifiersOf(chord));
        render::pushKey(window(), chord.key, false, KMOD_NONE);
        designer.frame(); // what comes a picture later is found with the next key
        EXPECT_TRUE(stateOf(designer, !owner.copies) == before) << nameOf(chord);
        if (endsOrEdits(chord)) {
            owner.close(designer); // as it was for the next key
            designer.frames(1);
            if (designer.app().menu().isOpen()) { // it had been closed by the key
                designer.key(SDLK_ESCAPE);
            }
        }
    }
    State const before = stateOf(designer, !owner.copies);
    designer.frames(2);
    EXPECT_TRUE(stateOf(designer, !owner.copies) == before) << "after the last key";
}

TEST(KeysOwner, TheSameKeysRunCommandsWhileNothingIsOpen) {
    Designer designer;
    designer.editText(room);
    std::size_t changed = 0;
    for (Chord const& chord : allKeys(designer)) {
        begin(designer);
        SDL_SetClipboardText("nothing");
        State const before = stateOf(designer, true);
        designer.key(chord.key, modifiersOf(chord));
        changed += stateOf(designer, true) == before ? 0 : 1;
        for (int i = 0; i < 3 && (designer.parts().dialogOpen() || designer.parts().test != nullptr ||
                                  designer.app().menu().isOpen() || designer.parts().panelKeys);
             ++i) {
            designer.key(SDLK_ESCAPE);
            designer.frames(1);
        }
    }
    EXPECT_GT(changed, 45U) << "else the test above would prove nothing";
}

TEST(KeysOwner, DeleteInAListKeepsTheObject) {
    Designer designer;
    designer.editText(room);
    begin(designer);
    click(designer, "add property");
    ASSERT_TRUE(KeysOwner::popup());
    std::size_t const before = designer.count("objects");
    designer.key(SDLK_DELETE);
    designer.key(SDLK_BACKSPACE);
    EXPECT_EQ(designer.count("objects"), before);
    EXPECT_TRUE(KeysOwner::popup());
    designer.key(SDLK_ESCAPE);
    designer.frames(2);
    EXPECT_FALSE(KeysOwner::popup());
    EXPECT_EQ(designer.parts().selected().size(), 2U) << "Esc closes the list and nothing else";
    designer.key(SDLK_DELETE);
    EXPECT_EQ(designer.count("objects"), before - 2) << "then the keys are the scene's again";
}

TEST(KeysOwner, APartInTheHandIsLetGoByEscapeWhileItsTileIsHeld) {
    Designer designer;
    designer.editText(room);
    designer.key(SDLK_F2);
    designer.frames(2);
    designer.moveTo(designer.item("part bell"));
    designer.press();
    designer.moveTo(designer.on({0, 2}));
    ASSERT_EQ(designer.parts().partInHand, "bell");
    designer.key(SDLK_ESCAPE);
    EXPECT_EQ(designer.parts().partInHand, "");
    designer.release();
}

} // namespace
} // namespace keys_owner_test
} // namespace trembler::ui::test
