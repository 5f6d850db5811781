// The page of keys, made from the command tables.
#include "game/ui/shared/commands/key_help.hpp"
#include "tests/game/ui/shared/commands/counting_screen.hpp"

#include <gtest/gtest.h>

namespace trembler::ui::test {
namespace {

std::vector<std::string> rows(KeyBindings const& bindings, std::span<Gesture const> gestures) {
    Counting counting;
    CommandsOf<Counting> const commands(countingTable, counting);
    std::vector<std::string> all;
    for (HelpLine const& line : helpLines(commands, gestures, bindings)) {
        all.push_back(line.keys + ": " + line.does);
    }
    return all;
}

TEST(KeyHelp, HasARowForEveryCommandWithAKey) {
    KeyBindings bindings(countingLists());
    EXPECT_EQ(rows(bindings, {}),
              (std::vector<std::string>{"W, ↑, Shift+W: go", "Ctrl+J: jump", "C: crouch", "Esc: leave"}));
    EXPECT_FALSE(bindings.bind(infoOf(bindings, "door"), {SDLK_d}));
    bindings.unbind(infoOf(bindings, "jump"));
    EXPECT_EQ(rows(bindings, {}),
              (std::vector<std::string>{"W, ↑, Shift+W: go", "C: crouch", "Esc: leave", "D: door"}));
}

TEST(KeyHelp, GesturesAreListedBesideTheirCommands) {
    KeyBindings const bindings(countingLists());
    constexpr Gesture gestures[] = {{"wheel", "go", "walk"}, {"click", "look", "jump"}};
    EXPECT_EQ(rows(bindings, gestures), (std::vector<std::string>{"wheel, W, ↑, Shift+W: go", "Ctrl+J: jump",
                                                                  "click: look", "C: crouch", "Esc: leave"}));
}

TEST(KeyHelp, MarkdownHasEveryGestureInItsGroup) {
    constexpr Gesture gestures[] = {{.with = "wheel", .does = "go", .beside = "walk"},
                                    {.with = "click", .does = "look", .group = CommandGroup::looking},
                                    {.with = "drag", .does = "carry"}};
    EXPECT_EQ(gesturesMarkdown(gestures), "| Building | |\n|---|---|\n| go | wheel |\n| carry | drag |\n"
                                          "\n| Looking | |\n|---|---|\n| look | click |\n");
    EXPECT_EQ(rows(KeyBindings(countingLists()), gestures).front(), "wheel, W, ↑, Shift+W: go");
}

TEST(KeyHelp, MarkdownHasEveryCommandOnce) {
    KeyBindings const bindings(countingLists());
    std::string const page = keysMarkdown(bindings);
    for (CommandInfo const* command : bindings.commands()) {
        std::string const id = "`" + std::string(command->id) + "` |";
        auto const at = page.find(id);
        ASSERT_NE(at, std::string::npos) << page;
        EXPECT_EQ(page.find(id, at + 1), std::string::npos) << id;
    }
    EXPECT_NE(page.find("| Jump | `Ctrl+J` | `jump` |\n"), std::string::npos) << page;
    EXPECT_NE(page.find("| Crouch | hold `C` | `crouch` |\n"), std::string::npos) << page;
    EXPECT_NE(page.find("| Door | – | `door` |\n"), std::string::npos) << page;
}

} // namespace
} // namespace trembler::ui::test
