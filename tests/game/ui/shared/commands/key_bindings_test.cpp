// Key bindings: the player's choices, and valid and invalid profiles.
#include "render/window/gamepad.hpp"
#include "tests/game/ui/shared/commands/counting_screen.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace trembler::ui::test {
namespace {

std::vector<Chord> keys(KeyBindings const& bindings, std::string_view id) {
    auto const all = bindings.keysOf(id);
    return {all.begin(), all.end()};
}

/// No two commands of a list have a chord in common; compares the chords without the bindings' own check.
void expectNoConflicts(KeyBindings const& bindings) {
    for (CommandList const& list : countingLists()) {
        std::map<std::string, std::string_view> owner;
        for (CommandInfo const* command : list.commands) {
            for (Chord const& chord : bindings.keysOf(command->id)) {
                auto const [found, fresh] = owner.emplace(nameOf(chord), command->id);
                EXPECT_TRUE(fresh) << nameOf(chord) << ": " << found->second << " and " << command->id;
            }
        }
    }
}

TEST(Bindings, BeginWithTheKeysOfTheTables) {
    KeyBindings const bindings(countingLists());
    EXPECT_EQ(keys(bindings, "walk"), (std::vector<Chord>{{SDLK_w}, {SDLK_UP}}));
    EXPECT_TRUE(keys(bindings, "door").empty());
    EXPECT_TRUE(keys(bindings, "no such").empty());
    EXPECT_EQ(bindings.commands().size(), countingTable.size() + 1)
        << "a command of two screens is listed once";
    EXPECT_TRUE(bindings.isDefault());
    EXPECT_TRUE(bindings.stated().empty());
}

TEST(Bindings, AKeyOfAnotherCommandIsRefusedWithAMessage) {
    KeyBindings bindings(countingLists());
    auto const why = bindings.bind(infoOf(bindings, "jump"), {SDLK_UP});
    ASSERT_TRUE(why);
    EXPECT_NE(why->find("Walk"), std::string::npos) << *why;
    EXPECT_NE(why->find("↑"), std::string::npos) << *why;
    EXPECT_EQ(keys(bindings, "jump"), std::vector<Chord>{withCtrl(SDLK_j)}) << "nothing has changed";
    EXPECT_FALSE(bindings.bind(infoOf(bindings, "jump"), withCtrl(SDLK_UP))) << "with Ctrl it is another one";
    // A command's own key is not a conflict, nor is a key of a screen that does not have the command.
    EXPECT_FALSE(bindings.bind(infoOf(bindings, "jump"), withCtrl(SDLK_UP)));
    EXPECT_FALSE(bindings.bind(infoOf(bindings, "paint"), {SDLK_j}));
    EXPECT_FALSE(bindings.bind(infoOf(bindings, "jump"), {SDLK_j}));
    // A command of both screens conflicts with commands of either.
    EXPECT_TRUE(bindings.bind(infoOf(bindings, "walk"), {SDLK_j}));
    expectNoConflicts(bindings);
}

TEST(Bindings, TheCommandThatLeadsBackHasItsKeyWithEveryModifier) {
    KeyBindings bindings(countingLists());
    EXPECT_TRUE(bindings.bind(infoOf(bindings, "jump"), withCtrl(SDLK_ESCAPE)));
    EXPECT_TRUE(bindings.bind(infoOf(bindings, "leave"), {SDLK_j})) << "Ctrl+J is another command's";
    EXPECT_FALSE(bindings.bind(infoOf(bindings, "leave"), withCtrl(SDLK_q)));
    EXPECT_EQ(keys(bindings, "leave"), std::vector<Chord>{{SDLK_q}});
    EXPECT_TRUE(bindings.bind(infoOf(bindings, "jump"), withCtrl(SDLK_q)));
    EXPECT_FALSE(bindings.bind(infoOf(bindings, "jump"), withCtrl(SDLK_ESCAPE))) << "it is free now";
    EXPECT_TRUE(bindings.bind(infoOf(bindings, "leave"), {SDLK_ESCAPE}));
    expectNoConflicts(bindings);
}

TEST(Bindings, AnEssentialCommandAlwaysHasAKey) {
    KeyBindings bindings(countingLists());
    auto const why = bindings.unbind(infoOf(bindings, "leave"));
    ASSERT_TRUE(why);
    EXPECT_NE(why->find("Leave"), std::string::npos) << *why;
    EXPECT_EQ(keys(bindings, "leave"), std::vector<Chord>{{SDLK_ESCAPE}});
    EXPECT_FALSE(bindings.unbind(infoOf(bindings, "jump")));
    EXPECT_TRUE(keys(bindings, "jump").empty());
}

TEST(Bindings, AreWrittenAndReadBack) {
    KeyBindings bindings(countingLists());
    EXPECT_FALSE(bindings.bind(infoOf(bindings, "walk"), withCtrlShift(SDLK_PLUS)));
    bindings.unbind(infoOf(bindings, "jump"));
    auto const stated = bindings.stated();
    EXPECT_EQ(stated, (StatedKeys{{"walk", {"Ctrl+Shift++"}}, {"jump", {}}})) << "only the changed commands";
    KeyBindings again(countingLists());
    EXPECT_TRUE(again.load(stated).empty());
    EXPECT_EQ(keys(again, "walk"), std::vector<Chord>{withCtrlShift(SDLK_PLUS)});
    EXPECT_TRUE(keys(again, "jump").empty());
    EXPECT_EQ(again.stated(), stated);
    again.reset();
    EXPECT_TRUE(again.isDefault());
}

TEST(Bindings, TwoCommandsMaySwapTheirKeys) {
    KeyBindings bindings(countingLists());
    EXPECT_TRUE(bindings.load({{"walk", {"Ctrl+J"}}, {"jump", {"W"}}}).empty());
    EXPECT_EQ(keys(bindings, "walk"), std::vector<Chord>{withCtrl(SDLK_j)});
    EXPECT_EQ(keys(bindings, "jump"), std::vector<Chord>{{SDLK_w}});
    expectNoConflicts(bindings);
}

TEST(Bindings, InvalidEntriesOfAProfileAreReportedAndTheOthersUsed) {
    KeyBindings bindings(countingLists());
    auto const troubles = bindings.load({{"walk", {"Spcae"}},
                                         {"fly", {"F"}},
                                         {"leave", {}},
                                         {"run", {"Ctrl+J"}}, // the key of "jump"
                                         {"paint", {"X", "X"}}});
    ASSERT_EQ(troubles.size(), 4U);
    std::string all;
    for (std::string const& trouble : troubles) {
        all += trouble + "\n";
    }
    for (char const* named : {"walk", "Spcae", "fly", "leave", "run", "Jump"}) {
        EXPECT_NE(all.find(named), std::string::npos) << named << " is not in\n" << all;
    }
    EXPECT_EQ(bindings.stated(), (StatedKeys{{"paint", {"X"}}}));
    expectNoConflicts(bindings);
}

TEST(Bindings, NoProfileTakesTheKeysOfAnEssentialCommand) {
    KeyBindings bindings(countingLists());
    EXPECT_EQ(bindings.load({{"leave", {}}}).size(), 1U);
    EXPECT_EQ(keys(bindings, "leave"), std::vector<Chord>{{SDLK_ESCAPE}});
    EXPECT_EQ(bindings.load({{"leave", {"Pad A"}}}).size(), 1U) << "a player may have no gamepad";
    EXPECT_EQ(keys(bindings, "leave"), std::vector<Chord>{{SDLK_ESCAPE}});
    EXPECT_TRUE(bindings.load({{"leave", {"Q"}}}).empty());
    EXPECT_EQ(keys(bindings, "leave"), std::vector<Chord>{{SDLK_q}});
}

TEST(Bindings, AConflictWithAUsualKeyIsResolved) {
    // "jump" gets the key of "walk"; the key for "walk" is refused, so it returns to its usual key, which
    // "jump" now has.
    KeyBindings bindings(countingLists());
    auto const troubles = bindings.load({{"jump", {"W"}}, {"walk", {"Escape"}}});
    EXPECT_EQ(troubles.size(), 2U);
    EXPECT_TRUE(bindings.isDefault());
}

TEST(Bindings, NoProfileMakesAConflict) {
    EXPECT_TRUE(rc::check([] {
        KeyBindings bindings(countingLists());
        StatedKeys stated;
        std::vector<std::string> const names{"W",      "Up", "Shift+W",  "Ctrl+J", "C",
                                             "Escape", "X",  "nonsense", ""};
        for (char const* id : {"walk", "run", "jump", "crouch", "leave", "door", "paint", "fly"}) {
            if (*rc::gen::inRange(0, 3) != 0) {
                stated[id] = *rc::gen::resize(
                    3, rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(names)));
            }
        }
        static_cast<void>(bindings.load(stated));
        expectNoConflicts(bindings);
        RC_ASSERT(!keys(bindings, "leave").empty());
        KeyBindings again(countingLists());
        RC_ASSERT(again.load(bindings.stated()).empty());
        RC_ASSERT(again.stated() == bindings.stated());
    }));
}

/// A screen whose commands all have one button of a gamepad.
struct OneButton {
    PadPhase now = PadPhase::running;
    bool mayLook = true;
    bool mayBuild = true;
    std::string done{};

    [[nodiscard]] PadPhase phase() const { return now; }
};
constexpr Chord theButton{render::padKey(SDL_CONTROLLER_BUTTON_A)};
constexpr std::array<Command<OneButton>, 4> oneButtonTable{
    {{.info = {.id = "go", .pad = theButton, .padPhase = PadPhase::running},
      .run = [](OneButton& screen) { screen.done = "go"; }},
     {.info = {.id = "look", .pad = theButton, .padPhase = PadPhase::past},
      .run = [](OneButton& screen) { screen.done = "look"; },
      .available = [](OneButton const& screen) { return screen.mayLook; }},
     {.info = {.id = "build", .pad = theButton, .padPhase = PadPhase::building},
      .run = [](OneButton& screen) { screen.done = "build"; },
      .available = [](OneButton const& screen) { return screen.mayBuild; }},
     {.info = {.id = "zoom", .pad = theButton, .padPhase = PadPhase::view},
      .run = [](OneButton& screen) { screen.done = "zoom"; }}}};

// While the past is shown, a button runs the most suitable of its commands that are available.
TEST(Bindings, AButtonOfAGamepadMeansWhatCanBeDoneNow) {
    KeyBindings const bindings({listOf(std::span<Command<OneButton> const>(oneButtonTable))});
    auto const pressed = [&](OneButton screen) {
        CommandsOf<OneButton> commands(oneButtonTable, screen);
        SDL_Keysym key{};
        key.sym = theButton.key;
        if (auto const index = bindings.find(commands, key)) {
            commands.run(*index);
        }
        return screen.done;
    };
    EXPECT_EQ(pressed({.now = PadPhase::running}), "go");
    EXPECT_EQ(pressed({.now = PadPhase::building}), "build");
    EXPECT_EQ(pressed({.now = PadPhase::past}), "look");
    EXPECT_EQ(pressed({.now = PadPhase::past, .mayLook = false}), "build");
    EXPECT_EQ(pressed({.now = PadPhase::past, .mayLook = false, .mayBuild = false}), "go");
    EXPECT_EQ(pressed({.now = PadPhase::view}), "zoom");
    EXPECT_EQ(pressed({.now = PadPhase::building, .mayBuild = false}), "") << "it means nothing else then";
}

TEST(Bindings, TipsNameTheCurrentKey) {
    KeyBindings bindings(countingLists());
    EXPECT_EQ(tipOf(infoOf(bindings, "jump"), false, bindings), "Jump (Ctrl+J)");
    EXPECT_EQ(tipOf(infoOf(bindings, "crouch"), false, bindings), "Crouch (hold C)");
    EXPECT_EQ(tipOf(infoOf(bindings, "door"), false, bindings), "Door (Esc)");
    EXPECT_FALSE(bindings.bind(infoOf(bindings, "jump"), {SDLK_F5}));
    EXPECT_EQ(tipOf(infoOf(bindings, "jump"), false, bindings), "Jump (F5)");
    bindings.unbind(infoOf(bindings, "jump"));
    EXPECT_EQ(tipOf(infoOf(bindings, "jump"), false, bindings), "Jump");
}

} // namespace
} // namespace trembler::ui::test
