// Each kind of change of a what-if, made with the mouse, keys or a gamepad alone, and the window while the
// other run is computed.
#include "game/ui/play/whatif/what_if.hpp"
#include "game/ui/play/whatif/what_if_tool.hpp"
#include "game/ui/tools/placing_tool.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "render/scene/facts/facts.hpp"
#include "render/scene/facts/poses.hpp"
#include "render/scene/objects/wires.hpp"
#include "runtime/placement.hpp"
#include "tests/game/ui/player.hpp"
#include "tests/game/ui/virtual_pad.hpp"

#include <algorithm>
#include <set>

namespace trembler::ui::test {
namespace what_if_changes_test {
namespace {

auto const magnetLevel = levelsFolder() / "first/1-first-contact.json";
using Kind = insight::Change::Kind;

/// A run in which a steel bar closes the circuit, and a what-if at a moment of it.
class WhatIfChanges : public testing::Test {
protected:
    void run(std::uint64_t frames, std::string const& bar = "steel bar") {
        player.open(magnetLevel);
        player.drag(player.item("part " + bar), player.at({-1.8, 1.2}));
        for (std::uint64_t i = 0; i < frames; ++i) {
            player.key(SDLK_f);
        }
        player.key(SDLK_k);
        player.frames(2);
    }
    void beginAt(std::uint64_t frame, std::uint64_t frames = 100) {
        run(frames);
        hash = player.session().world().stateHash();
        player.play().timeline().seek(frame);
        player.frames(2);
        player.key(SDLK_z);
        await();
        player.key(SDLK_HOME); // the cards lie over the scene, until the player asks to see all of it
        player.frames(2);
    }
    void await() {
        player.frame(); // a change is taken up with the next picture
        for (int i = 0; i < 6000 && view().moving(); ++i) {
            player.frame();
        }
        player.frames(4); // the card has found its size
    }
    WhatIfView const& view() { return player.play().whatIf(); }
    Vec2 placeOf(std::string const& name) { return placeIn(player.play().timeline().world(), name); }
    static Vec2 placeIn(World const& world, std::string const& name) {
        Position const* const place = world.find<Position>(world.store().find(name));
        EXPECT_NE(place, nullptr) << name;
        return place == nullptr ? Vec2{} : place->value;
    }
    /// Begins a what-if at that frame, and waits until all is computed.
    void buildOneWorldInAPicture(std::uint64_t frame) {
        player.play().timeline().seek(frame);
        player.frames(2);
        player.hold(SDLK_z);
        ASSERT_TRUE(view().active());
        ASSERT_EQ(view().moment(), frame);
        EXPECT_EQ(view().worldsBuilt(), 0);
        double before = view().progress();
        for (int worlds = 1; worlds <= WhatIfView::worldsToBuild; ++worlds) {
            player.frame();
            EXPECT_EQ(view().worldsBuilt(), worlds);
            EXPECT_TRUE(view().working());
            EXPECT_GT(view().progress(), before);
            if (frame > 0 || worlds < WhatIfView::worldsToBuild) {
                EXPECT_EQ(view().run(), nullptr) << "no frame is computed in these pictures";
            } else {
                ASSERT_NE(view().run(), nullptr) << "it begins with its worlds";
                EXPECT_EQ(view().run()->frame(), 0U);
            }
            before = view().progress();
        }
        EXPECT_TRUE(player.shows("what if computing"))
            << "the card is drawn meanwhile, and has found its size";
        player.letGo(SDLK_z);
        await();
        EXPECT_EQ(view().worldsBuilt(), WhatIfView::worldsToBuild);
        EXPECT_DOUBLE_EQ(view().progress(), 1);
    }
    /// Opens the list of effects on the card, chooses an effect to leave out, and waits.
    void leaveOut(std::string const& interaction) {
        player.scrollTo("what if", "leave out");
        player.clickItem("leave out");
        player.frames(2);
        switchEffect(interaction);
    }
    /// The same in the open list: an effect that is left out is included again.
    void switchEffect(std::string const& interaction) {
        player.scrollTo("what if", "without " + interaction);
        player.clickItem("without " + interaction);
        await();
    }
    /// The only change, which is of this kind and leads to another run; the real run is unchanged.
    insight::Change const& onlyChange(Kind kind) {
        static insight::Change const none;
        EXPECT_EQ(view().whatIf().changes.size(), 1U);
        if (view().whatIf().changes.empty() || view().run() == nullptr) {
            ADD_FAILURE() << "nothing was changed";
            return none;
        }
        EXPECT_EQ(view().whatIf().changes.front().kind, kind);
        EXPECT_TRUE(view().run()->firstDifference());
        EXPECT_EQ(player.session().world().stateHash(), hash);
        EXPECT_FALSE(player.session().altered());
        return view().whatIf().changes.front();
    }

    Player player;
    std::uint64_t hash = 0;
};

TEST_F(WhatIfChanges, AWireIsCutWithTheScissors) {
    beginAt(5);
    World const& world = player.play().timeline().world();
    render::FactsReader const reader(world);
    render::Facts const a = reader.of(world.store().find("battery plus"));
    render::Facts const b = reader.of(world.store().find("left contact"));
    auto const path = render::cablePath(a, render::poseOf(a), b, render::poseOf(b));
    render::Point const middle = player.play().camera().toScreen(path[path.size() / 2]);
    player.key(SDLK_x);
    player.click(middle);
    await();
    insight::Change const& change = onlyChange(Kind::cut);
    std::set<std::string> const ends{change.object, change.other};
    EXPECT_EQ(ends, (std::set<std::string>{"battery plus", "left contact"}));
    ASSERT_EQ(view().run()->goals().size(), 2U);
    EXPECT_FALSE(view().run()->goals().front().frame) << "no current without that wire";
    EXPECT_TRUE(player.session().judge().status().front().frame) << "in the real run there is";
}

TEST_F(WhatIfChanges, AFieldIsSetOnItsCard) {
    beginAt(5);
    player.click(player.at(placeOf("iron ball")));
    player.frames(2);
    player.scrollTo("what if", "set mass.value");
    Point const number = player.item("set mass.value");
    player.drag(number, number + Point{120, 0}, MouseButton::Left, 8);
    await();
    insight::Change const& change = onlyChange(Kind::field);
    EXPECT_EQ(change.object, "iron ball");
    EXPECT_EQ(change.property, "mass");
    EXPECT_GT(change.amount.x,
              player.session().world().find<Mass>(player.session().world().store().find("iron ball"))->value);
}

TEST_F(WhatIfChanges, AnEffectIsLeftOut) {
    beginAt(5);
    std::string const magnetism = "(Dynamics <- Magnetic Forces) Interaction";
    leaveOut(magnetism);
    EXPECT_EQ(onlyChange(Kind::interaction).object, magnetism);
    player.key(SDLK_END);
    player.frames(2);
    WhatIfView& changed = const_cast<WhatIfView&>(view()); // world() restores the frame
    World const* const other = changed.world();
    ASSERT_NE(other, nullptr);
    EXPECT_LT(placeIn(*other, "iron ball").y, placeOf("iron ball").y) << "nothing lifts it";
    player.play().timeline().seek(5);
    player.frames(2);
    switchEffect(magnetism);
    EXPECT_TRUE(view().whatIf().changes.empty());
    EXPECT_FALSE(view().run()->firstDifference());
}

TEST_F(WhatIfChanges, AnEffectThatIsLeftOutIsTakenBackBesideIt) {
    beginAt(5);
    leaveOut("(Dynamics <- Gravity) Interaction");
    ASSERT_EQ(view().whatIf().changes.size(), 1U);
    player.moveTo(player.layout().card("what if")->middle());
    for (int i = 0; i < 40 && !player.shows("take back 0"); ++i) {
        player.wheel(1);
    }
    player.frames(2);
    player.clickItem("take back 0");
    await();
    EXPECT_TRUE(view().whatIf().changes.empty());
}

// Placed parts too, and not only objects that move by themselves.
TEST_F(WhatIfChanges, APlacedPartIsMovedAndRemoved) {
    beginAt(30);
    Vec2 const from = placeOf("steel bar 1");
    player.drag(player.at(from), player.at(from + Vec2{0, 0.9}));
    await();
    EXPECT_EQ(onlyChange(Kind::place).object, "steel bar 1");
    EXPECT_LE(*view().run()->firstDifference(), 31U);
    player.key(SDLK_DELETE);
    await();
    EXPECT_EQ(onlyChange(Kind::remove).object, "steel bar 1") << "in place of the other change";
    player.clickItem("take back 0");
    await();
    EXPECT_FALSE(view().run()->firstDifference());
}

// However long the run is, a picture computes a part of it: the window stays responsive, shows the progress,
// and can cancel the work.
TEST_F(WhatIfChanges, TheWindowGoesOnWhileItIsComputed) {
    std::uint64_t const frames = 40 * PicturePace::mostFrames;
    run(60, "wooden bar"); // which solves nothing
    player.key(SDLK_p);    // continues
    player.simulate(static_cast<int>(frames));
    player.key(SDLK_p);
    player.play().timeline().seek(20);
    player.frames(2);
    player.key(SDLK_z);
    player.frames(2);
    ASSERT_TRUE(view().working());
    ASSERT_TRUE(player.shows("what if computing"));
    double const before = view().progress();
    player.frames(2);
    EXPECT_TRUE(view().working()) << "it is not computed in one go";
    EXPECT_GT(view().progress(), before);
    // In the meantime everything else works.
    player.clickItem("timeline track");
    EXPECT_NE(player.play().timeline().frame(), 20U);
    player.play().timeline().seek(20);
    player.frames(4); // the card has found its size
    ASSERT_TRUE(view().working());
    player.clickItem("what if computing");
    ASSERT_TRUE(view().stopped());
    double const stoppedAt = view().progress();
    player.frames(5);
    EXPECT_EQ(view().progress(), stoppedAt);
    EXPECT_FALSE(view().moving()) << "nothing is drawn for its sake";
    player.clickItem("what if computing");
    EXPECT_FALSE(view().stopped());
    player.frames(2);
    EXPECT_GT(view().progress(), stoppedAt);
    player.key(SDLK_ESCAPE);
    EXPECT_TRUE(view().stopped()) << "the first one stops the computing, at " << view().progress() << " of "
                                  << player.play().timeline().last();
    player.key(SDLK_ESCAPE);
    EXPECT_FALSE(view().active()) << "the second one ends the what-if";
}

// A big level takes long to build: the window draws between its worlds.
TEST_F(WhatIfChanges, NoPictureBuildsMoreThanOneWorld) {
    run(60);
    buildOneWorldInAPicture(20);
    ASSERT_NE(view().run(), nullptr);
    EXPECT_FALSE(view().run()->firstDifference());
    // After a change, the run before it is shown until the new one has reached the moment.
    insight::OtherRun const* const shown = view().run();
    player.key(SDLK_HOME); // the timeline lies over the ball
    player.frames(2);
    Vec2 const from = placeOf("iron ball");
    player.drag(player.at(from), player.at(from + Vec2{0.6, 0.4}));
    EXPECT_EQ(view().run(), shown);
    EXPECT_LT(view().worldsBuilt(), WhatIfView::worldsToBuild);
    await();
    EXPECT_NE(view().run(), shown);
    EXPECT_TRUE(view().run()->firstDifference());
}

TEST_F(WhatIfChanges, NoPictureBuildsMoreThanOneWorldAtTheStartEither) {
    run(60);
    buildOneWorldInAPicture(0);
    ASSERT_NE(view().run(), nullptr);
    EXPECT_FALSE(view().run()->firstDifference());
}

// All that the gamepad does in the test below, by keys: the arrows move a pointer, and Return is its button.
TEST_F(WhatIfChanges, KeysAloneDoAllOfIt) {
    run(60);
    hash = player.session().world().stateHash();
    player.moveTo(player.at({1.6, 0.2})); // the keys' pointer begins where the mouse was last
    player.key(SDLK_PAGEUP);              // a frame back
    ASSERT_TRUE(player.play().timeline().looksBack());
    player.key(SDLK_z);
    ASSERT_TRUE(view().active());
    await();
    Vec2 const ball = placeOf("iron ball");
    player.moveTo(player.at(ball));
    player.key(SDLK_UP);
    player.key(SDLK_DOWN);
    player.key(SDLK_RETURN);
    // It is dragged where the pointer goes.
    player.hold(SDLK_RETURN);
    for (int i = 0; i < 6; ++i) {
        player.key(SDLK_LEFT);
    }
    player.letGo(SDLK_RETURN);
    await();
    EXPECT_EQ(onlyChange(Kind::place).object, "iron ball");
    EXPECT_NEAR(view().whatIf().changes.front().at.x, ball.x - 6 * gridStep, gridStep);
    // Along the card to its first number, which is changed.
    player.key(SDLK_F9);
    auto const isField = [](insight::Change const& change) { return change.kind == Kind::field; };
    bool set = false;
    for (int i = 0; i < 12 && !set; ++i) {
        player.key(SDLK_DOWN);
        player.key(SDLK_SPACE);
        for (int step = 0; step < 4; ++step) {
            player.key(SDLK_RIGHT);
        }
        player.key(SDLK_SPACE);
        auto const& changes = view().whatIf().changes;
        set = std::any_of(changes.begin(), changes.end(), isField);
    }
    EXPECT_TRUE(set) << "the card is worked by keys";
    EXPECT_EQ(player.session().mode(), SessionMode::paused) << "they do nothing else meanwhile";
    player.key(SDLK_ESCAPE); // back to the field
    EXPECT_TRUE(view().active());
    player.key(SDLK_DELETE); // the ball is still chosen
    await();
    ASSERT_FALSE(view().whatIf().changes.empty());
    EXPECT_EQ(view().whatIf().changes.back().kind, Kind::remove);
    player.look("what-if-by-keys");
    player.key(SDLK_z);
    EXPECT_FALSE(view().active());
    EXPECT_EQ(player.session().world().stateHash(), hash);
}

TEST_F(WhatIfChanges, AGamepadDoesAllOfIt) {
    VirtualPad const pad;
    if (!pad.works()) {
        GTEST_SKIP() << "no gamepads here";
    }
    run(60);
    hash = player.session().world().stateHash();
    // From here on only the gamepad is used; its pointer begins where the mouse was last.
    player.moveTo(player.at({1.6, 0.2}));
    pad.push(player, SDL_CONTROLLER_AXIS_RIGHTX, -30000); // a frame back
    ASSERT_TRUE(player.play().timeline().looksBack());
    pad.press(player, SDL_CONTROLLER_BUTTON_LEFTSHOULDER);
    ASSERT_TRUE(view().active());
    await();
    // A number: the ball is chosen, and its card has the buttons.
    Vec2 const ball = placeOf("iron ball");
    player.moveTo(player.at(ball));
    pad.press(player, SDL_CONTROLLER_BUTTON_DPAD_UP);
    pad.press(player, SDL_CONTROLLER_BUTTON_DPAD_DOWN);
    pad.press(player, SDL_CONTROLLER_BUTTON_A);
    // It is dragged where the pointer goes.
    pad.hold(player, SDL_CONTROLLER_BUTTON_A, true);
    for (int i = 0; i < 6; ++i) {
        pad.press(player, SDL_CONTROLLER_BUTTON_DPAD_LEFT);
    }
    pad.hold(player, SDL_CONTROLLER_BUTTON_A, false);
    await();
    EXPECT_EQ(onlyChange(Kind::place).object, "iron ball");
    EXPECT_NEAR(view().whatIf().changes.front().at.x, ball.x - 6 * gridStep, gridStep);
    pad.press(player, SDL_CONTROLLER_BUTTON_RIGHTSHOULDER);
    // Along the card to its first number, which is changed.
    auto const isField = [](insight::Change const& change) { return change.kind == Kind::field; };
    bool set = false;
    for (int i = 0; i < 12 && !set; ++i) {
        pad.press(player, SDL_CONTROLLER_BUTTON_DPAD_DOWN);
        pad.press(player, SDL_CONTROLLER_BUTTON_A);
        for (int step = 0; step < 4; ++step) {
            pad.press(player, SDL_CONTROLLER_BUTTON_DPAD_RIGHT);
        }
        pad.press(player, SDL_CONTROLLER_BUTTON_A);
        auto const& changes = view().whatIf().changes;
        set = std::any_of(changes.begin(), changes.end(), isField);
    }
    EXPECT_TRUE(set) << "the card is worked by buttons";
    EXPECT_EQ(player.session().mode(), SessionMode::paused) << "they do nothing else meanwhile";
    pad.press(player, SDL_CONTROLLER_BUTTON_RIGHTSHOULDER);
    pad.press(player, SDL_CONTROLLER_BUTTON_BACK); // the ball is still chosen
    await();
    ASSERT_FALSE(view().whatIf().changes.empty());
    EXPECT_EQ(view().whatIf().changes.back().kind, Kind::remove);
    pad.press(player, SDL_CONTROLLER_BUTTON_LEFTSHOULDER);
    EXPECT_FALSE(view().active());
    EXPECT_EQ(player.session().world().stateHash(), hash);
}

// The time of a computation depends on the clock; its result does not.
TEST(WhatIfPace, NothingDependsOnTheClock) {
    Player player;
    player.open(magnetLevel);
    player.drag(player.item("part steel bar"), player.at({-1.8, 1.2}));
    for (int i = 0; i < 50; ++i) {
        player.key(SDLK_f);
    }
    std::set<std::uint64_t> hashes;
    std::set<int> pictures;
    for (double const perLook : {0.0, 1e-3, 1.0}) { // s, by which the clock advances at each reading
        double now = 0;
        Timeline& timeline = player.play().timeline();
        timeline.setOpen(true);
        timeline.seek(10);
        WhatIfView view(gameData().registry, player.session(), timeline, [&] { return now += perLook; });
        ASSERT_TRUE(view.begin());
        view.change({.kind = Kind::place, .object = "iron ball", .at = {1.2, 0.6}});
        int count = 0;
        do {
            view.pass();
            ++count;
        } while (view.working() && count < 1000);
        ASSERT_NE(view.run(), nullptr);
        EXPECT_EQ(view.run()->frame(), 50U);
        hashes.insert(view.run()->run().world().stateHash());
        pictures.insert(count);
        view.end();
    }
    EXPECT_EQ(hashes.size(), 1U);
    EXPECT_GT(pictures.size(), 1U);
}

} // namespace
} // namespace what_if_changes_test
} // namespace trembler::ui::test
