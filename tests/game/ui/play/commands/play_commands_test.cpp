// The table of the level's screen and those of all others: no duplicates, no missing texts.
#include "game/ui/app/command_lists.hpp"
#include "game/ui/play/commands/play_commands.hpp"
#include "tests/game/ui/player.hpp"

#include <cstring>
#include <map>
#include <regex>
#include <set>

namespace trembler::ui::test {
namespace {

TEST(Commands, EachIsListedOnceAndHasTexts) {
    for (CommandList const& list : commandLists()) {
        std::set<std::string_view> ids;
        for (CommandInfo const* command : list.commands) {
            EXPECT_TRUE(ids.insert(command->id).second) << command->id << " is a duplicate";
            EXPECT_TRUE(std::regex_match(std::string(command->id), std::regex("[a-z]+(-[a-z]+)*")))
                << command->id << " is stored in profiles";
            for (char const* text : {command->name, command->tip, command->help}) {
                EXPECT_GT(std::strlen(text), 0U) << command->id;
            }
            EXPECT_EQ(std::string(command->tip).find('('), std::string::npos)
                << command->id << ": keys are added to its tip automatically, the text must not contain them";
        }
    }
}

TEST(Commands, NoTwoOfAScreenHaveAKeyInCommon) {
    for (CommandList const& list : commandLists()) {
        std::map<std::string, std::string_view> owners;
        for (CommandInfo const* command : list.commands) {
            for (Chord const& chord : command->keys) {
                if (chord.any()) {
                    auto const [owner, fresh] = owners.emplace(nameOf(chord), command->id);
                    EXPECT_TRUE(fresh) << nameOf(chord) << ": " << owner->second << " and " << command->id;
                    EXPECT_EQ(chordFrom(nameOf(chord)), chord) << "a profile can name it";
                }
            }
        }
    }
}

TEST(Commands, AnIdMeansTheSameOnEveryScreen) {
    std::map<std::string_view, CommandInfo const*> known;
    for (CommandList const& list : commandLists()) {
        for (CommandInfo const* command : list.commands) {
            auto const [first, fresh] = known.emplace(command->id, command);
            EXPECT_EQ(first->second->keys, command->keys) << command->id;
            EXPECT_STREQ(first->second->tip, command->tip) << command->id;
        }
    }
}

TEST(Commands, CommandsThatAreNamedByOthersExist) {
    std::set<std::string_view> ids;
    for (Command<PlayParts> const& command : playCommands()) {
        EXPECT_NE(command.run, nullptr) << command.info.id;
        ids.insert(command.info.id);
    }
    for (Command<PlayParts> const& command : playCommands()) {
        EXPECT_TRUE(command.info.alsoBy.empty() || ids.contains(command.info.alsoBy)) << command.info.id;
    }
    for (Gesture const& gesture : playGestures()) {
        EXPECT_TRUE(gesture.beside.empty() || ids.contains(gesture.beside)) << gesture.with;
    }
}

/// Players and their profiles rely on these keys and ids: they must not change.
TEST(Commands, UsualKeysStayAsTheyAre) {
    KeyBindings const bindings(commandLists());
    std::map<std::string, std::string> const usual{{"run", "Space"},
                                                   {"pause", "P"},
                                                   {"step", "F"},
                                                   {"fast", "Tab"},
                                                   {"slower", "- Keypad -"},
                                                   {"faster", "+ ="},
                                                   {"normal-speed", "0 Keypad 0"},
                                                   {"turn-left", "Q"},
                                                   {"turn-right", "E"},
                                                   {"flip", "V"},
                                                   {"move-left", "Left"},
                                                   {"move-right", "Right"},
                                                   {"move-up", "Up"},
                                                   {"move-down", "Down"},
                                                   {"put-back", "Delete"},
                                                   {"next-part", "T"},
                                                   {"previous-part", "Shift+T"},
                                                   {"act", "Return Keypad Enter"},
                                                   {"choose-all", "Ctrl+A"},
                                                   {"choose-more", ""},
                                                   {"duplicate", "Ctrl+D"},
                                                   {"undo", "Ctrl+Z"},
                                                   {"redo", "Ctrl+Shift+Z Ctrl+Y"},
                                                   {"all-back", "Backspace"},
                                                   {"fit", "Home"},
                                                   {"view-left", "Ctrl+Left"},
                                                   {"view-right", "Ctrl+Right"},
                                                   {"view-up", "Ctrl+Up"},
                                                   {"view-down", "Ctrl+Down"},
                                                   {"zoom-in", "Ctrl++ Ctrl+="},
                                                   {"zoom-out", "Ctrl+- Ctrl+Keypad -"},
                                                   {"move-view", ""},
                                                   {"inspect", "I"},
                                                   {"electricity", "1"},
                                                   {"magnetism", "2"},
                                                   {"contacts", "3"},
                                                   {"names", "N"},
                                                   {"cut", "X"},
                                                   {"second-hand", "G"},
                                                   {"second-left", ""},
                                                   {"second-right", ""},
                                                   {"second-up", ""},
                                                   {"second-down", ""},
                                                   {"second-grab", ""},
                                                   {"what-if", "Z"},
                                                   {"what-if-card", "F9"},
                                                   {"why", "Y"},
                                                   {"why-goal", "Shift+Y"},
                                                   {"why-before", "A"},
                                                   {"why-next", "D"},
                                                   {"wire", "W"},
                                                   {"find-part", "Ctrl+F /"},
                                                   {"next-group", "S"},
                                                   {"previous-group", "Shift+S"},
                                                   {"hint", "H"},
                                                   {"components", "C F3"},
                                                   {"mods", "M"},
                                                   {"budget", "B"},
                                                   {"less-budget", ","},
                                                   {"more-budget", "."},
                                                   {"record", "R"},
                                                   {"picture", "F12"},
                                                   {"save", "Ctrl+S"},
                                                   {"solutions", ""},
                                                   {"levels", "L"},
                                                   {"back", "Escape"},
                                                   {"menu", ""},
                                                   {"help", "F1"},
                                                   {"fullscreen", "F11"},
                                                   {"restart", ""},
                                                   {"next-level", ""},
                                                   {"watch-again", ""},
                                                   {"keep-playing", ""},
                                                   {"timeline", "K"},
                                                   {"frame-back", "PageUp"},
                                                   {"frame-on", "PageDown"},
                                                   {"mark-back", "Ctrl+PageUp"},
                                                   {"mark-on", "Ctrl+PageDown"},
                                                   {"past-start", "Ctrl+Home"},
                                                   {"past-end", "End"},
                                                   {"watch-past", "O"},
                                                   {"probe", "F4"},
                                                   {"loop-past", "J"},
                                                   {"continue-here", "U"},
                                                   {"menu-up", "Up"},
                                                   {"menu-down", "Down"},
                                                   {"menu-left", "Left"},
                                                   {"menu-right", "Right"},
                                                   {"menu-press", "Return Space Keypad Enter"},
                                                   {"menu-next", "Tab"},
                                                   {"menu-before", "Shift+Tab"},
                                                   {"menu-type", ""},
                                                   {"menu-erase", "Delete"},
                                                   {"menu-page-next", ""},
                                                   {"menu-page-before", ""},
                                                   {"letters-erase", ""},
                                                   {"letters-space", ""},
                                                   {"letters-left", ""},
                                                   {"letters-right", ""},
                                                   {"letters-capitals", ""},
                                                   {"letters-signs", ""},
                                                   {"letters-done", ""}};
    std::map<std::string, std::string> now;
    for (CommandInfo const* command : bindings.commands()) {
        if (command->id.starts_with("edit-")) {
            continue; // the editor's own
        }
        std::string& keys = now[std::string(command->id)];
        for (Chord const& chord : bindings.keysOf(command->id)) {
            if (!render::isPadKey(chord.key)) {
                keys += (keys.empty() ? "" : " ") + nameOf(chord);
            }
        }
    }
    EXPECT_EQ(now, usual);
}

TEST(Commands, KeysDoWhatTheyAreBoundTo) {
    Player player;
    player.open(levelsFolder() / "first/1-first-contact.json");
    KeyBindings& keys = player.app().context().keys;
    CommandInfo const* electricity = nullptr;
    for (CommandInfo const* command : keys.commands()) {
        electricity = command->id == "electricity" ? command : electricity;
    }
    ASSERT_NE(electricity, nullptr);
    EXPECT_FALSE(keys.bind(*electricity, withCtrl(SDLK_k)));
    player.key(SDLK_1);
    EXPECT_FALSE(player.play().shown().electricity);
    player.key(SDLK_k);
    EXPECT_FALSE(player.play().shown().electricity);
    player.key(SDLK_k, KMOD_RCTRL);
    EXPECT_TRUE(player.play().shown().electricity);
}

TEST(Commands, UnavailableCommandsDoNothing) {
    Player player;
    player.open(levelsFolder() / "first/1-first-contact.json");
    player.key(SDLK_x); // nothing runs
    EXPECT_FALSE(player.play().hand().cutting());
    player.key(SDLK_p);
    EXPECT_EQ(player.session().mode(), SessionMode::building);
    player.key(SDLK_BACKSPACE); // nothing is placed
    player.drag(player.item("part steel bar"), player.at({-1.8, 1.5}));
    player.key(SDLK_BACKSPACE);
    EXPECT_EQ(player.session().placed().size(), 1U) << "the first time it only asks";
    player.key(SDLK_BACKSPACE);
    EXPECT_TRUE(player.session().placed().empty());
    // Escape releases the part in the hand even while Ctrl, which disables the grid, is held.
    player.clickItem("part steel bar");
    ASSERT_TRUE(player.play().placing().carried());
    player.key(SDLK_ESCAPE, KMOD_LCTRL);
    EXPECT_FALSE(player.play().placing().carried());
    EXPECT_FALSE(player.app().menu().isOpen());
}

} // namespace
} // namespace trembler::ui::test
