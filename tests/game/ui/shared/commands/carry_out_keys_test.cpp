// Key events run commands, also with the modifiers that tools use.
#include "game/ui/shared/commands/carry_out_keys.hpp"
#include "tests/game/ui/shared/commands/counting_screen.hpp"

#include <gtest/gtest.h>

namespace trembler::ui::test {
namespace {

using Done = std::map<std::string, int>;

/// The commands that the key events of one picture run.
Done after(std::vector<SDL_Event> const& events, bool mayJump = true) {
    Counting counting;
    counting.mayJump = mayJump;
    CommandsOf<Counting> commands(countingTable, counting);
    KeyBindings const bindings(countingLists());
    carryOutKeys(events, bindings, commands);
    return counting.done;
}

TEST(Keys, CarryOutTheirCommands) {
    EXPECT_EQ(after({keyDown(SDLK_w)}), (Done{{"w", 1}}));
    EXPECT_EQ(after({keyDown(SDLK_UP)}), (Done{{"w", 1}}));
    EXPECT_EQ(after({keyDown(SDLK_j, KMOD_RCTRL), keyDown(SDLK_w)}), (Done{{"j", 1}, {"w", 1}}));
    EXPECT_EQ(after({keyDown(SDLK_q)}), Done{});
    EXPECT_EQ(after({keyDown(SDLK_j)}), Done{}) << "without Ctrl it is another key";
    EXPECT_EQ(after({keyDown(SDLK_j, KMOD_LCTRL)}, false), Done{}) << "it is not available";
}

TEST(Keys, ModifiersCountWhereACommandNamesThem) {
    EXPECT_EQ(after({keyDown(SDLK_w, KMOD_LSHIFT)}), (Done{{"r", 1}}));
    EXPECT_EQ(after({keyDown(SDLK_UP, KMOD_LSHIFT)}), (Done{{"w", 1}}))
        << "no command has it with Shift, which tools use";
    EXPECT_EQ(after({keyDown(SDLK_w, KMOD_LALT)}), (Done{{"w", 1}}));
    EXPECT_EQ(after({keyDown(SDLK_w, KMOD_LCTRL)}), Done{});
    EXPECT_EQ(after({keyDown(SDLK_j, KMOD_LCTRL | KMOD_LSHIFT)}), (Done{{"j", 1}}));
    EXPECT_EQ(after({keyDown(SDLK_ESCAPE, KMOD_LCTRL)}), (Done{{"l", 1}}))
        << "a key that leads back works with any modifier";
}

TEST(Keys, RepeatOnlyForRepeatingCommands) {
    EXPECT_EQ(after({keyDown(SDLK_j, KMOD_LCTRL, true)}), (Done{{"j", 1}}));
    EXPECT_EQ(after({keyDown(SDLK_w, KMOD_NONE, true)}), Done{});
    EXPECT_EQ(after({keyDown(SDLK_w), keyDown(SDLK_w), keyDown(SDLK_UP)}), (Done{{"w", 1}}))
        << "once per picture";
    EXPECT_EQ(after({keyDown(SDLK_c)}), Done{}) << "it is held, not pressed";
}

TEST(Keys, KeysAfterTheOneThatLeavesTheScreenAreIgnored) {
    EXPECT_EQ(after({keyDown(SDLK_w), keyDown(SDLK_ESCAPE), keyDown(SDLK_j, KMOD_LCTRL)}),
              (Done{{"l", 1}, {"w", 1}}));
}

} // namespace
} // namespace trembler::ui::test
