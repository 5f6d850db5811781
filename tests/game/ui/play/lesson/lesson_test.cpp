// The first level teaches by actions: with the mouse, with keys, with a gamepad.
#include "game/ui/play/lesson/lesson.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/game/ui/drawn_text.hpp"
#include "tests/game/ui/drawn_words.hpp"
#include "tests/game/ui/virtual_pad.hpp"

#include <algorithm>

namespace trembler::ui::test {
namespace lesson_test {
namespace {

using Kind = TeachingStep::Kind;

auto const firstLevel = levelsFolder() / "first/1-first-contact.json";

std::optional<Kind> shownIn(Player& player) {
    TeachingStep const* const step = player.play().lesson().step();
    return step == nullptr ? std::nullopt : std::optional(step->kind);
}

Vec2 goalOf(Player& player) {
    return player.session().level().teaching.front().at;
}

void expectSolved(Player& player) {
    EXPECT_FALSE(shownIn(player)) << "nothing is left to be shown";
    player.simulate(600);
    EXPECT_TRUE(player.session().solved());
    EXPECT_TRUE(player.play().lesson().over());
}

TEST(FirstLesson, ByMouse) {
    Player player;
    player.open(firstLevel);
    player.frames(30);
    ASSERT_EQ(shownIn(player), Kind::place);
    EXPECT_EQ(player.play().lesson().device(), InputDevice::mouse);
    player.look("lesson-1-720");
    player.drag(player.item("part steel bar"), player.at(goalOf(player) + Vec2{1, 0.5}));
    ASSERT_EQ(player.session().placed().size(), 1U);
    player.frames(30);
    EXPECT_EQ(shownIn(player), Kind::place) << "it lies elsewhere";
    player.look("lesson-2-720");
    player.drag(player.at(player.session().placed()[0].placement.at), player.at(goalOf(player)));
    player.frames(30);
    EXPECT_EQ(shownIn(player), Kind::run);
    player.look("lesson-3-720");
    player.clickItem("run");
    expectSolved(player);
}

TEST(FirstLesson, ByKeys) {
    Player player;
    player.open(firstLevel);
    player.key(SDLK_t);
    ASSERT_EQ(shownIn(player), Kind::place);
    EXPECT_EQ(player.play().lesson().device(), InputDevice::keys);
    player.look("lesson-keys-720");
    auto const& pointer = player.play().keyPointer();
    for (int i = 0; i < 200 && std::abs(pointer.at().x - goalOf(player).x) > 0.03; ++i) {
        player.key(pointer.at().x > goalOf(player).x ? SDLK_LEFT : SDLK_RIGHT);
    }
    for (int i = 0; i < 200 && std::abs(pointer.at().y - goalOf(player).y) > 0.03; ++i) {
        player.key(pointer.at().y > goalOf(player).y ? SDLK_DOWN : SDLK_UP);
    }
    player.key(SDLK_RETURN);
    player.frames(2);
    EXPECT_EQ(shownIn(player), Kind::run);
    player.key(SDLK_SPACE);
    expectSolved(player);
}

TEST(FirstLesson, ByKeysWhatLiesElsewhereIsFetched) {
    Player player;
    player.open(firstLevel);
    Vec2 const elsewhere = goalOf(player) + Vec2{1, 0.5};
    player.drag(player.item("part steel bar"), player.at(elsewhere));
    ASSERT_EQ(player.session().placed().size(), 1U);
    auto const says = [&](char const* words) {
        std::vector<std::string> const lines = DrawnWords().lines();
        return std::any_of(lines.begin(), lines.end(),
                           [&](std::string const& line) { return line.find(words) != std::string::npos; });
    };
    auto const place = [&] { return player.session().placed()[0].placement.at; };
    Vec2 const before = place();
    player.key(SDLK_LEFT);
    ASSERT_EQ(player.play().lesson().device(), InputDevice::keys);
    player.look("lesson-keys-elsewhere-720");
    EXPECT_FALSE(says("out of the toolbox")) << "none is left in it";
    EXPECT_TRUE(says("move it here"));
    EXPECT_LT(place().x, before.x) << "it is selected: the keys do as they are said to";
    player.click(player.at(place() + Vec2{0, 0.7})); // selects nothing
    player.key(SDLK_LEFT);
    player.look("lesson-keys-fetch-720");
    EXPECT_FALSE(says("out of the toolbox"));
    EXPECT_TRUE(says("move the pointer to it"));
}

TEST(FirstLesson, TheNoteHidesNoWordsOfACard) {
    int over = 0;
    for (render::Size const size : {render::Size{1280, 720}, render::Size{800, 600}}) {
        Player player(size);
        for (char const* const command : {"components", "hint"}) {
            player.open(firstLevel);
            player.frames(30);
            player.play().commands().run(command);
            player.frames(10);
            Point const above = player.at(goalOf(player)) - Point{0, 45};
            for (DrawnText const& one : drawnTexts()) {
                for (Placed const& card : player.layout().cards()) {
                    if (one.text == "Drag this here") {
                        EXPECT_FALSE(one.rect.overlaps(card.rect) && card.name != "toolbox") << card.name;
                    }
                }
            }
            for (Placed const& card : player.layout().cards()) {
                over += card.rect.contains(above) && card.name != "toolbox" ? 1 : 0;
            }
            player.look(std::string("lesson-beside-") + command + std::to_string(size.width));
        }
    }
    EXPECT_GT(over, 0) << "else nothing is tested";
}

TEST(FirstLesson, ByGamepad) {
    Player player;
    VirtualPad const pad;
    if (!pad.works()) {
        GTEST_SKIP() << "SDL has no virtual gamepads here: " << SDL_GetError();
    }
    player.open(firstLevel);
    pad.push(player, SDL_CONTROLLER_AXIS_TRIGGERRIGHT, 30000);
    ASSERT_TRUE(player.play().placing().carried());
    EXPECT_EQ(player.play().lesson().device(), InputDevice::pad);
    auto const& pointer = player.play().keyPointer();
    auto const button = [&](double way, SDL_GameControllerButton more, SDL_GameControllerButton less) {
        return way > 0 ? more : less;
    };
    for (int i = 0; i < 200 && std::abs(goalOf(player).x - pointer.at().x) > 0.03; ++i) {
        pad.press(player, button(goalOf(player).x - pointer.at().x, SDL_CONTROLLER_BUTTON_DPAD_RIGHT,
                                 SDL_CONTROLLER_BUTTON_DPAD_LEFT));
    }
    for (int i = 0; i < 200 && std::abs(goalOf(player).y - pointer.at().y) > 0.03; ++i) {
        pad.press(player, button(goalOf(player).y - pointer.at().y, SDL_CONTROLLER_BUTTON_DPAD_UP,
                                 SDL_CONTROLLER_BUTTON_DPAD_DOWN));
    }
    pad.press(player, SDL_CONTROLLER_BUTTON_A);
    EXPECT_EQ(shownIn(player), Kind::run);
    player.look("lesson-pad-720");
    pad.press(player, SDL_CONTROLLER_BUTTON_X);
    expectSolved(player);
}

TEST(FirstLesson, ComesToRestAndIsNotRepeatedOnceTheLevelIsSolved) {
    Player player;
    player.open(firstLevel);
    EXPECT_TRUE(player.play().lesson().moving());
    for (int i = 0; i < 14; ++i) {
        player.app().frame(1);
    }
    EXPECT_FALSE(player.play().lesson().moving()) << "at rest no picture is drawn that shows nothing new";
    EXPECT_EQ(shownIn(player), Kind::place);
    player.app().context().profile.markSolved("first/1-first-contact.json");
    player.open(firstLevel);
    EXPECT_FALSE(shownIn(player));
}

/// Steps of every kind, one after the other.
TEST(Lessons, FollowWhatIsDone) {
    Session session(gameData().registry, gameData().parts, [] {
        LevelFile level = loadLevel(gameData().registry, dataFolder() / "wires.json");
        TeachingStep wire;
        wire.kind = Kind::wire;
        wire.object = "plus";
        wire.other = "lamp";
        TeachingStep run;
        run.kind = Kind::run;
        TeachingStep cut = wire;
        cut.kind = Kind::cut;
        level.teaching = {wire, run, cut};
        return level;
    }());
    Lesson lesson(session, true);
    auto const shown = [&] {
        lesson.look({}, 0.1);
        return lesson.step() == nullptr ? std::nullopt : std::optional(lesson.step()->kind);
    };
    EXPECT_EQ(shown(), Kind::wire);
    auto const find = [&](char const* name) { return session.world().store().find(name); };
    ASSERT_TRUE(session.layWire(find("lamp"), find("plus")));
    EXPECT_EQ(shown(), Kind::run);
    ASSERT_TRUE(session.undo());
    EXPECT_EQ(shown(), Kind::wire) << "it was taken away again";
    ASSERT_TRUE(session.redo());
    session.start();
    EXPECT_EQ(shown(), Kind::cut);
    session.feed({PlayerInput::Kind::cut, find("lamp"), find("plus"), {}});
    session.step();
    EXPECT_EQ(shown(), std::nullopt);
    EXPECT_TRUE(lesson.over());
}

} // namespace
} // namespace lesson_test
} // namespace trembler::ui::test
