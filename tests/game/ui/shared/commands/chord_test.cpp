// Names of keys with modifiers.
#include "game/ui/shared/commands/chord.hpp"

#include <gtest/gtest.h>

#include <initializer_list>

namespace trembler::ui::test {
namespace {

SDL_Keysym pressed(SDL_Keycode key, int modifiers) {
    SDL_Keysym keysym{};
    keysym.sym = key;
    keysym.mod = static_cast<std::uint16_t>(modifiers);
    return keysym;
}

TEST(Chords, AreReadAsTheyAreWritten) {
    for (SDL_Keycode const key : {SDLK_a, SDLK_SPACE, SDLK_F11, SDLK_LEFT, SDLK_COMMA, SDLK_PLUS, SDLK_MINUS,
                                  SDLK_KP_5, SDLK_DELETE, SDLK_HOME, SDLK_ESCAPE}) {
        for (bool const ctrl : {false, true}) {
            for (bool const shift : {false, true}) {
                for (bool const alt : {false, true}) {
                    Chord const chord{key, ctrl, shift, alt};
                    auto const again = chordFrom(nameOf(chord));
                    ASSERT_TRUE(again) << nameOf(chord);
                    EXPECT_EQ(*again, chord) << nameOf(chord);
                }
            }
        }
    }
}

TEST(Chords, HaveNamesForPeople) {
    EXPECT_EQ(nameOf(withCtrlShift(SDLK_z)), "Ctrl+Shift+Z");
    EXPECT_EQ(nameOf({SDLK_ESCAPE}), "Escape");
    EXPECT_EQ(labelOf({SDLK_ESCAPE}), "Esc");
    EXPECT_EQ(labelOf(withCtrl(SDLK_LEFT)), "Ctrl+←");
    EXPECT_EQ(nameOf({}), "");
    EXPECT_EQ(labelOf({}), "");
}

TEST(Chords, SpellingMayDifferInCaseAndOrderOnly) {
    EXPECT_EQ(chordFrom("ctrl+SHIFT+z"), withCtrlShift(SDLK_z));
    EXPECT_EQ(chordFrom("Shift+Ctrl+Z"), withCtrlShift(SDLK_z));
    EXPECT_EQ(chordFrom("Ctrl++"), withCtrl(SDLK_PLUS));
    for (char const* nonsense :
         {"", "Ctrl", "Ctrl+", "Left Shift", "Ctrl+Left Alt", "Spcae", "Super+P", "P ", "\x01"}) {
        EXPECT_FALSE(chordFrom(nonsense)) << nonsense;
    }
}

TEST(Chords, LockKeysMakeNoDifference) {
    EXPECT_EQ(chordOf(pressed(SDLK_p, KMOD_NUM | KMOD_CAPS)), Chord{SDLK_p});
    EXPECT_EQ(chordOf(pressed(SDLK_z, KMOD_RCTRL | KMOD_LSHIFT)), withCtrlShift(SDLK_z));
    EXPECT_EQ(chordOf(pressed(SDLK_z, KMOD_LALT)), (Chord{.key = SDLK_z, .alt = true}));
    EXPECT_TRUE(isModifier(SDLK_RCTRL));
    EXPECT_FALSE(isModifier(SDLK_TAB));
}

} // namespace
} // namespace trembler::ui::test
