// What-ifs with real input events: the mouse, keys and a gamepad change something in the past, and the real
// run stays as it was.
#include "game/ui/play/timeline/probe_panel.hpp"
#include "game/ui/play/whatif/what_if.hpp"
#include "game/ui/tools/placing_tool.hpp"
#include "runtime/placement.hpp"
#include "tests/game/ui/player.hpp"
#include "tests/game/ui/tidy.hpp"
#include "tests/game/ui/virtual_pad.hpp"

namespace trembler::ui::test {
namespace what_if_test {
namespace {

auto const contactLevel = levelsFolder() / "first/1-first-contact.json";
using Kind = insight::Change::Kind;

/// Runs the level, won by a steel bar, and shows a moment of the run.
void lookAt(Player& player, std::uint64_t frame, std::uint64_t frames = 90) {
    player.open(contactLevel);
    player.drag(player.item("part steel bar"), player.at({-1.8, 1.2}));
    for (std::uint64_t i = 0; i < frames; ++i) {
        player.key(SDLK_f);
    }
    player.key(SDLK_k);
    player.frames(2);
    player.key(SDLK_HOME); // the timeline lies over the floor, until the player asks to see everything
    player.frames(2);
    player.play().timeline().seek(frame);
    player.frames(2);
}

/// Waits until the other run is computed.
void await(Player& player) {
    player.frame(); // a change is taken up with the next picture
    for (int i = 0; i < 6000 && player.play().whatIf().moving(); ++i) {
        player.frame();
    }
    player.frames(4); // the card has found its size
}

Vec2 ballAt(Player& player) {
    World const& world = player.play().timeline().world();
    return world.find<Position>(world.store().find("iron ball"))->value;
}

TEST(WhatIf, AnObjectThatIsDraggedAwayMakesAnotherRun) {
    Player player;
    lookAt(player, 20);
    std::uint64_t const hash = player.session().world().stateHash();
    auto const inputs = player.session().inputs().size();
    player.clickItem("what if");
    WhatIfView const& view = player.play().whatIf();
    ASSERT_TRUE(view.active());
    await(player);
    ASSERT_TRUE(player.showsCard("what if"));
    ASSERT_TRUE(player.showsCard("what if lane"));
    EXPECT_FALSE(view.run()->firstDifference());
    Vec2 const from = ballAt(player);
    player.drag(player.at(from), player.at(from + Vec2{0.6, 0.4}));
    await(player);
    ASSERT_EQ(view.whatIf().changes.size(), 1U);
    EXPECT_EQ(view.whatIf().changes.front().kind, Kind::place);
    EXPECT_EQ(view.whatIf().changes.front().object, "iron ball");
    ASSERT_TRUE(view.run());
    EXPECT_EQ(view.run()->firstDifference(), 21U);
    EXPECT_EQ(view.run()->frame(), 90U);
    EXPECT_FALSE(view.run()->paths().empty());
    player.look("what-if-moment");
    player.play().timeline().seek(60);
    player.frames(2);
    player.look("what-if-later");
    player.key(SDLK_z);
    EXPECT_FALSE(view.active());
    EXPECT_EQ(view.kept().size(), 1U);
    player.key(SDLK_END);
    EXPECT_EQ(player.session().world().stateHash(), hash) << "the real run is as it was, to the bit";
    EXPECT_EQ(player.session().inputs().size(), inputs);
    EXPECT_FALSE(player.session().altered());
    EXPECT_FALSE(player.session().whyNotRecorded());
}

TEST(WhatIf, KeysTurnMoveAndRemoveWhatIsChosen) {
    Player player;
    lookAt(player, 20);
    player.key(SDLK_z);
    WhatIfView const& view = player.play().whatIf();
    ASSERT_TRUE(view.active());
    await(player);
    player.click(player.at(ballAt(player)));
    Vec2 const from = ballAt(player);
    player.key(SDLK_RIGHT);
    await(player);
    ASSERT_EQ(view.whatIf().changes.size(), 1U);
    EXPECT_NEAR(view.whatIf().changes.front().at.x, from.x + gridStep, 1e-9);
    player.key(SDLK_q);
    await(player);
    ASSERT_EQ(view.whatIf().changes.size(), 1U);
    EXPECT_NEAR(view.whatIf().changes.front().at.x, from.x + gridStep, 1e-9);
    EXPECT_NE(view.whatIf().changes.front().angle, 0);
    player.key(SDLK_DELETE);
    await(player);
    ASSERT_EQ(view.whatIf().changes.size(), 1U);
    EXPECT_EQ(view.whatIf().changes.front().kind, Kind::remove);
    EXPECT_TRUE(view.run()->firstDifference());
    player.clickItem("take back 0");
    await(player);
    EXPECT_TRUE(view.whatIf().changes.empty());
    EXPECT_FALSE(view.run()->firstDifference());
    player.key(SDLK_ESCAPE); // the inspector
    player.key(SDLK_ESCAPE);
    EXPECT_FALSE(view.active());
    EXPECT_NE(player.findPlay(), nullptr);
}

TEST(WhatIf, TheSecondHandPullsAndTheLastOneIsKept) {
    Player player;
    lookAt(player, 20);
    player.key(SDLK_z);
    WhatIfView const& view = player.play().whatIf();
    await(player);
    player.hold(SDLK_g);
    Vec2 const from = ballAt(player);
    player.drag(player.at(from), player.at(from + Vec2{0.2, 0.8}));
    player.letGo(SDLK_g);
    await(player);
    ASSERT_EQ(view.whatIf().changes.size(), 1U);
    EXPECT_EQ(view.whatIf().changes.front().kind, Kind::grab);
    auto const differs = view.run()->firstDifference();
    ASSERT_TRUE(differs);
    player.key(SDLK_z);
    player.frames(2);
    EXPECT_FALSE(player.showsCard("what if lane"));
    player.key(SDLK_z);
    await(player);
    EXPECT_TRUE(view.whatIf().changes.empty());
    player.clickItem("what if again");
    await(player);
    EXPECT_EQ(view.run()->firstDifference(), differs);
    player.key(SDLK_SPACE); // the run ends, and so do its what-ifs
    EXPECT_FALSE(view.active());
    EXPECT_TRUE(view.kept().empty());
}

TEST(WhatIf, PlotsShowBothRuns) {
    Player player;
    lookAt(player, 20);
    ProbePanel& probes = player.play().timeline().probes();
    probes.toggle("iron ball.position.x");
    player.key(SDLK_z);
    await(player);
    player.key(SDLK_HOME); // above the plot, too
    player.frames(4);
    Vec2 const from = ballAt(player);
    player.drag(player.at(from), player.at(from + Vec2{0.6, 0.4}));
    await(player);
    player.frames(4);
    ASSERT_EQ(probes.other().series().size(), 1U);
    insight::Series const& other = probes.other().series().front();
    ASSERT_FALSE(other.samples.empty());
    EXPECT_EQ(other.samples.front().frame, 20U);
    EXPECT_NEAR(*other.at(20), from.x + 0.6, 0.02);
    EXPECT_NEAR(*probes.probes().series().front().at(20), from.x, 1e-9);
    player.look("what-if-plots");
}

TEST(WhatIf, AGamepadChoosesTurnsAndRemoves) {
    VirtualPad const pad;
    if (!pad.works()) {
        GTEST_SKIP() << "no gamepads here";
    }
    Player player;
    lookAt(player, 20);
    pad.press(player, SDL_CONTROLLER_BUTTON_LEFTSHOULDER);
    WhatIfView const& view = player.play().whatIf();
    ASSERT_TRUE(view.active());
    await(player);
    Vec2 const from = ballAt(player);
    // The pointer of the keys goes to the ball, where A holds it.
    player.moveTo(player.at(from));
    pad.press(player, SDL_CONTROLLER_BUTTON_DPAD_UP);
    pad.press(player, SDL_CONTROLLER_BUTTON_DPAD_DOWN);
    pad.press(player, SDL_CONTROLLER_BUTTON_A);
    pad.press(player, SDL_CONTROLLER_BUTTON_LEFTSTICK);
    await(player);
    ASSERT_EQ(view.whatIf().changes.size(), 1U);
    EXPECT_NE(view.whatIf().changes.front().angle, 0);
    pad.press(player, SDL_CONTROLLER_BUTTON_BACK);
    await(player);
    ASSERT_EQ(view.whatIf().changes.size(), 1U);
    EXPECT_EQ(view.whatIf().changes.front().kind, Kind::remove);
}

TEST(WhatIf, ItsCardsFitAtEverySize) {
    for (render::Size const size :
         {render::Size{800, 600}, render::Size{1280, 720}, render::Size{1920, 1080}}) {
        Player player(size);
        lookAt(player, 20);
        player.key(SDLK_z);
        await(player);
        player.click(player.at(ballAt(player)));
        player.key(SDLK_RIGHT);
        await(player);
        std::string const where = "what if at " + std::to_string(size.width);
        expectTidy(player, where);
        player.look("what-if-" + std::to_string(size.width));
    }
}

} // namespace
} // namespace what_if_test
} // namespace trembler::ui::test
