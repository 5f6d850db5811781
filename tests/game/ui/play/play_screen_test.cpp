// Running, winning and looking into the world, with real input events.
#include "physics/dynamics/properties/body.hpp"
#include "runtime/placement.hpp"
#include "tests/game/ui/player.hpp"

#include <cstring>
#include <fstream>

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

TEST(Running, TheInspectorShowsEveryProperty) {
    Player player;
    player.open(experiment);
    player.key(SDLK_SPACE);
    player.simulate(120);
    player.key(SDLK_p);
    World const& world = player.session().world();
    ObjectId const magnet = world.store().find("electromagnet");
    player.click(player.at({1.8, 1.7}));
    player.frames(3);
    ASSERT_TRUE(player.showsCard("inspector"));
    EXPECT_EQ(player.play().inspector().name(), "electromagnet");
    std::vector<std::string> titles;
    std::string all;
    for (InspectorSection const& section : player.play().inspector().shown()) {
        titles.push_back(section.title);
        for (InspectorRow const& row : section.rows) {
            all += row.name + "=" + row.value + " " + row.unit + "\n";
        }
    }
    for (ColumnBase const* column : world.store().columns()) {
        if (column->has(magnet)) {
            EXPECT_NE(std::find(titles.begin(), titles.end(), column->info().text.name), titles.end())
                << column->info().text.name << " is missing";
        }
    }
    EXPECT_NE(all.find("strength=150000 A m"), std::string::npos) << all;
    EXPECT_NE(all.find("electricity=on"), std::string::npos) << all;
    EXPECT_NE(all.find("touches=metal object"), std::string::npos) << all;
    EXPECT_NE(all.find("magnetic force="), std::string::npos) << all;
    player.clickItem("close inspector");
    player.frames(2);
    EXPECT_FALSE(player.showsCard("inspector"));
}

TEST(Running, TheComponentsPanelIsOpenedAndClosed) {
    Player player;
    player.open(experiment);
    player.key(SDLK_c);
    player.frames(2);
    EXPECT_TRUE(player.showsCard("components"));
    player.key(SDLK_F3);
    player.frames(2);
    EXPECT_FALSE(player.showsCard("components"));
    player.clickItem("components");
    player.frames(2);
    EXPECT_TRUE(player.showsCard("components"));
    std::vector<std::string> effects;
    for (EffectLevels const& levels : effectLevels(player.session().world())) {
        effects.push_back(levels.effect);
        EXPECT_GE(levels.levels.size(), 2U);
    }
    EXPECT_NE(std::find(effects.begin(), effects.end(), "electricity"), effects.end());
    EXPECT_NE(std::find(effects.begin(), effects.end(), "gravity"), effects.end());
}

TEST(Running, ClipsAndPicturesAreWrittenWithoutTheInterface) {
    Player player;
    std::filesystem::remove_all(player.films());
    player.open(experiment);
    player.key(SDLK_SPACE);
    player.frames(2);
    player.key(SDLK_r);
    EXPECT_TRUE(player.play().commands().on(player.play().commands().indexOf("record")));
    auto const first = player.session().world().frame();
    player.frames(8);
    player.look("recording-720");
    player.key(SDLK_r);
    EXPECT_GE(player.session().world().frame(), first + 8);
    EXPECT_TRUE(std::filesystem::exists(player.films() / "clip-1.webp"));
    player.key(SDLK_p);
    player.key(SDLK_F12);
    ASSERT_TRUE(std::filesystem::exists(player.films() / "picture-1.png"));
    auto const image = render::readPng(player.films() / "picture-1.png");
    ASSERT_EQ(image.size(), (render::Size{1280, 720}));
    render::Image const screen = player.look("picture-720");
    Point const goals = player.layout().card("goal")->middle();
    auto const x = static_cast<int>(goals.x);
    int different = 0;
    for (int y = static_cast<int>(goals.y) - 30; y < static_cast<int>(goals.y) + 30; ++y) {
        different += image.at(x, y) == screen.at(x, y) ? 0 : 1;
    }
    EXPECT_GT(different, 20) << "no card lies over the world";
    auto const column = static_cast<int>(player.layout().card("goal")->low.x) + 40;
    for (int y = 24; y < 100; ++y) {                 // not even a card's shadow: paper is light
        EXPECT_GT(image.at(column, y)[0], 192) << y; // a shadow is at 186
    }
    player.clickItem("picture");
    EXPECT_TRUE(std::filesystem::exists(player.films() / "picture-2.png"));
}

TEST(Running, HintsComeOneAtATime) {
    Player player;
    player.open(firstContact);
    EXPECT_EQ(player.play().hintsShown(), 0U);
    player.key(SDLK_h);
    EXPECT_EQ(player.play().hintsShown(), 1U);
    player.frames(2); // the card grows
    player.clickItem("hint");
    EXPECT_EQ(player.play().hintsShown(), 2U);
    for (int i = 0; i < 9; ++i) {
        player.key(SDLK_h);
    }
    EXPECT_EQ(player.play().hintsShown(), player.session().level().hints.size());
}

TEST(Running, OverlaysAreToggledByKeyAndButton) {
    Player player;
    player.open(experiment);
    player.key(SDLK_1);
    EXPECT_TRUE(player.play().shown().electricity);
    player.key(SDLK_2);
    EXPECT_TRUE(player.play().shown().magnetism);
    player.key(SDLK_3);
    EXPECT_TRUE(player.play().shown().contacts);
    for (char const* name : {"electricity", "magnetism", "contacts"}) {
        player.clickItem(name);
    }
    EXPECT_FALSE(player.play().shown().electricity || player.play().shown().magnetism ||
                 player.play().shown().contacts);
}

} // namespace
} // namespace play_screen_test
} // namespace trembler::ui::test
