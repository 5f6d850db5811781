// Running, winning, watching again and cutting, with real input events.
#include "physics/dynamics/properties/body.hpp"
#include "runtime/placement.hpp"
#include "tests/game/ui/player.hpp"

#include <cstring>

namespace trembler::ui::test {
namespace play_screen_test {
namespace {

auto const firstContact = levelsFolder() / "first/1-first-contact.json";
auto const experiment = levelsFolder() / "experiments/1-switched-electromagnet.json";

/// The bits of every placement, for exact comparison.
std::string bitsOf(Session const& session) {
    std::string bits;
    for (PlacedPart const& placed : session.placed()) {
        double const numbers[] = {placed.placement.at.x, placed.placement.at.y, placed.placement.angle};
        bits += placed.placement.part + std::to_string(placed.number);
        bits.append(reinterpret_cast<char const*>(numbers), sizeof numbers);
    }
    return bits;
}

TEST(Running, FirstContactIsWonByMouse) {
    Player player;
    player.drawEveryPicture(); // from the toolbox to the next level, as on a player's screen
    player.open(firstContact);
    player.drag(player.item("part steel bar"), player.at({-1.8, 1.2}));
    ASSERT_EQ(player.session().placed().size(), 1U);
    player.clickItem("run");
    player.simulate(600);
    EXPECT_TRUE(player.session().solved());
    player.frames(3);
    EXPECT_TRUE(player.showsCard("success"));
    EXPECT_TRUE(player.app().context().profile.solved("first/1-first-contact.json"));
    player.look("success-720");
    UiContext const& context = player.app().context();
    auto const next = context.levels.next(context.profile.progress(), firstContact)->file;
    player.clickItem("next level");
    EXPECT_EQ(player.play().file(), next);
}

TEST(Running, AWoodenBarDoesNotWin) {
    Player player;
    player.open(firstContact);
    player.drag(player.item("part wooden bar"), player.at({-1.8, 1.2}));
    ASSERT_EQ(player.session().placed().size(), 1U);
    player.key(SDLK_SPACE);
    player.simulate(900);
    EXPECT_GE(player.session().world().frame(), 900U);
    EXPECT_FALSE(player.session().solved());
    EXPECT_FALSE(player.showsCard("success"));
    EXPECT_FALSE(player.app().context().profile.solved("first/1-first-contact.json"));
}

TEST(Running, StopPutsEverythingBackExactly) {
    Player player;
    player.open(firstContact);
    player.drag(player.item("part steel bar"), player.at({-1.8, 1.4}));
    player.key(SDLK_q);
    player.key(SDLK_q, KMOD_LSHIFT);
    player.drag(player.item("part spanner"), player.at({-1.1, 2.1}));
    ASSERT_EQ(player.session().placed().size(), 2U);
    std::string const before = bitsOf(player.session());
    auto const hash = player.session().world().stateHash();
    player.key(SDLK_SPACE);
    player.frames(2);
    EXPECT_FALSE(player.showsCard("toolbox"));
    player.simulate(200);
    EXPECT_NE(player.session().world().stateHash(), hash);
    player.clickItem("stop");
    EXPECT_EQ(player.session().mode(), SessionMode::building);
    EXPECT_EQ(bitsOf(player.session()), before);
    EXPECT_EQ(player.session().world().stateHash(), hash);
    EXPECT_EQ(player.session().world().frame(), 0U);
    player.key(SDLK_SPACE); // runs again, with the same result
    player.simulate(200);
    player.key(SDLK_SPACE);
    EXPECT_EQ(player.session().world().stateHash(), hash);
}

TEST(Running, PauseAndSingleFrames) {
    Player player;
    player.open(experiment);
    player.key(SDLK_f);
    EXPECT_EQ(player.session().world().frame(), 1U);
    player.frames(10);
    EXPECT_EQ(player.session().world().frame(), 1U);
    player.key(SDLK_f);
    player.clickItem("step");
    EXPECT_EQ(player.session().world().frame(), 3U);
    player.key(SDLK_p);
    auto const resumed = player.session().world().frame();
    player.frames(6);
    EXPECT_EQ(player.session().world().frame(), resumed + 6)
        << "a sixtieth of a second per picture is a frame";
    player.key(SDLK_p);
    auto const paused = player.session().world().frame();
    player.frames(5);
    EXPECT_EQ(player.session().world().frame(), paused);
    player.key(SDLK_p);
    auto const before = player.session().world().frame();
    player.hold(SDLK_TAB);
    player.frames(4);
    player.letGo(SDLK_TAB);
    EXPECT_GE(player.session().world().frame(), before + 20);
    // The run is paused while the menu is open.
    player.key(SDLK_ESCAPE);
    EXPECT_TRUE(player.app().menu().isOpen());
    auto const behind = player.session().world().frame();
    player.frames(5);
    EXPECT_EQ(player.session().world().frame(), behind);
    player.clickItem("menu.resume");
    player.frames(2);
    EXPECT_GT(player.session().world().frame(), behind);
}

TEST(Running, TheSwitchIsLiftedByMouseAndTheRunCanBeWatchedAgain) {
    Player player;
    player.open(experiment);
    player.key(SDLK_SPACE);
    player.simulate(120);
    auto const& world = [&]() -> World const& { return player.session().world(); };
    auto const lever = [&] { return world().store().find("switch"); };
    auto const on = [&] {
        auto const* state = world().find<ElectricalState>();
        return state != nullptr && state->isOn(world().store().find("electromagnet"));
    };
    EXPECT_TRUE(on());
    Vec2 const from = world().find<Position>(lever())->value;
    player.moveTo(player.at(from));
    player.press();
    for (int i = 1; i <= 12; ++i) {
        player.moveTo(player.at(from + Vec2{0, 0.06 * i}));
    }
    player.frames(40);
    EXPECT_EQ(player.play().hand().held(), lever());
    EXPECT_GT(world().find<Position>(lever())->value.y, from.y + 0.4);
    EXPECT_FALSE(on());
    player.look("dragging-720");
    player.release();
    EXPECT_FALSE(player.play().hand().held().valid());
    player.frames(2);
    EXPECT_FALSE(player.session().inputs().empty());
    auto const frame = world().frame();
    auto const hash = world().stateHash();
    // Watched again, bit for bit.
    player.play().commands().run("watch-again");
    while (world().frame() < frame) {
        player.frame();
    }
    EXPECT_EQ(world().frame(), frame);
    EXPECT_EQ(world().stateHash(), hash);
}

TEST(Running, AWatchedRunIsThePlayersOwnAfterKeepPlaying) {
    Player player;
    player.open(firstContact);
    player.drag(player.item("part steel bar"), player.at({-1.8, 1.2}));
    player.key(SDLK_SPACE);
    player.simulate(600);
    ASSERT_TRUE(player.session().solved());
    player.frames(3);
    player.clickItem("watch again");
    player.simulate(600);
    ASSERT_TRUE(player.session().playing());
    player.frames(3);
    player.clickItem("keep playing");
    EXPECT_FALSE(player.session().playing());
    EXPECT_EQ(player.session().mode(), SessionMode::running);
}

TEST(Running, AWireIsCut) {
    Player player;
    player.open(experiment);
    player.key(SDLK_SPACE);
    player.simulate(120);
    player.clickItem("cut");
    EXPECT_TRUE(player.play().hand().cutting());
    World const& world = player.session().world();
    ObjectId const a = world.store().find("object 2");
    ObjectId const b = world.store().find("object 3");
    ASSERT_TRUE(connectionBetween(world.store(), a, b).any());
    render::FactsReader const reader(world);
    auto const path =
        render::cablePath(reader.of(a), render::poseOf(world, a), reader.of(b), render::poseOf(world, b));
    Point const middle = path[path.size() / 2];
    player.moveTo(player.at({middle.x, middle.y}));
    player.frames(2);
    EXPECT_TRUE(player.play().hand().wireUnderBlades().a.valid());
    player.look("cutting-720");
    player.click(player.at({middle.x, middle.y}));
    player.frames(4);
    EXPECT_FALSE(connectionBetween(world.store(), a, b).any());
    EXPECT_FALSE(world.find<ElectricalState>()->isOn(world.store().find("electromagnet")));
    player.key(SDLK_ESCAPE);
    EXPECT_FALSE(player.play().hand().cutting());
}

} // namespace
} // namespace play_screen_test
} // namespace trembler::ui::test
