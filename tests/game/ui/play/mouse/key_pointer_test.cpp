// The level's screen without a mouse: the pointer that keys move, and one key as the button.
#include "tests/game/ui/player.hpp"

#include <algorithm>

namespace trembler::ui::test {
namespace key_pointer_test {
namespace {

class KeysAlone : public testing::Test {
protected:
    void steps(SDL_Keycode key, int count) {
        for (int i = 0; i < count; ++i) {
            player.key(key);
        }
    }
    /// Moves the pointer to a place on the grid.
    void go(Vec2 to) {
        if (!player.play().keyPointer().active()) {
            player.key(SDLK_LEFT);
        }
        Vec2 const way = to - player.play().keyPointer().at();
        auto const count = [](double length) {
            return static_cast<int>(std::lround(std::abs(length) / gridStep));
        };
        steps(way.x < 0 ? SDLK_LEFT : SDLK_RIGHT, count(way.x));
        steps(way.y < 0 ? SDLK_DOWN : SDLK_UP, count(way.y));
        EXPECT_NEAR(length(player.play().keyPointer().at() - to), 0, 1e-9);
    }
    /// Runs Experiment I and holds its lever by the key.
    ObjectId holdTheLever() {
        player.open(levelsFolder() / "experiments/1-switched-electromagnet.json");
        player.key(SDLK_SPACE);
        player.simulate(60);
        ObjectId const lever = player.session().world().store().find("switch");
        Vec2 const at = player.session().world().find<Position>(lever)->value;
        go({std::round(at.x / gridStep) * gridStep, std::round(at.y / gridStep) * gridStep});
        player.hold(SDLK_RETURN);
        player.frames(20);
        return lever;
    }
    Player player;
};

TEST_F(KeysAlone, WinTheFirstLevel) {
    player.open(levelsFolder() / "first/1-first-contact.json");
    player.key(SDLK_t);
    ASSERT_TRUE(player.play().placing().carried());
    EXPECT_EQ(player.play().placing().carried()->landing.part, "steel bar");
    go({-1.8, 1.2});
    player.look("keys-alone");
    player.key(SDLK_RETURN);
    ASSERT_EQ(player.session().placed().size(), 1U);
    EXPECT_FALSE(player.play().placing().carried());
    player.key(SDLK_SPACE);
    player.simulate(600);
    EXPECT_TRUE(player.session().solved());
}

TEST_F(KeysAlone, WalkThroughTheToolboxAndMoveAPlacedPart) {
    player.open(levelsFolder() / "first/1-first-contact.json");
    auto const inHand = [&] {
        auto const& carried = player.play().placing().carried();
        return carried ? carried->landing.part : std::string();
    };
    for (char const* part : {"steel bar", "wooden bar", "spanner", "", "steel bar"}) {
        player.key(SDLK_t);
        EXPECT_EQ(inHand(), part);
    }
    go({-1.5, 1.5});
    player.key(SDLK_q);
    player.key(SDLK_RETURN);
    ASSERT_EQ(player.session().placed().size(), 1U);
    player.hold(SDLK_RETURN);
    go({-1.0, 2.0});
    player.letGo(SDLK_RETURN);
    player.frames(2);
    ASSERT_EQ(player.session().placed().size(), 1U);
    EXPECT_NEAR(length(player.session().placed()[0].placement.at - Vec2{-1.0, 2.0}), 0, 1e-9);
    player.moveTo({200, 400}); // the mouse takes over
    player.moveTo({210, 400});
    EXPECT_FALSE(player.play().keyPointer().active());
    player.key(SDLK_RIGHT);
    EXPECT_NEAR(player.session().placed()[0].placement.at.x, -1.0 + gridStep, 1e-9) << "the selected part";
}

TEST_F(KeysAlone, TakeHoldOfAThingInARun) {
    ObjectId const lever = holdTheLever();
    EXPECT_EQ(player.play().hand().held(), lever);
    player.letGo(SDLK_RETURN);
    player.frames(2);
    EXPECT_FALSE(player.play().hand().held().valid());
}

TEST_F(KeysAlone, LayAWire) {
    player.open(dataFolder() / "wires.json");
    player.key(SDLK_w);
    go({-1.6, 0.4});
    player.key(SDLK_RETURN);
    go({-0.4, 1.6});
    player.key(SDLK_RETURN);
    EXPECT_EQ(player.session().wires().size(), 1U);
}

TEST_F(KeysAlone, TheSecondHandHoldsAnotherThing) {
    player.open(levelsFolder() / "experiments/1-switched-electromagnet.json");
    player.key(SDLK_SPACE);
    player.simulate(30);
    World const* world = &player.session().world();
    ObjectId const lever = world->store().find("switch");
    Vec2 const at = world->find<Position>(lever)->value;
    player.moveTo(player.at(at));
    player.press();
    player.frames(20);
    ASSERT_EQ(player.play().hand().held(), lever);
    player.hold(SDLK_g);
    player.release();
    player.frames(3);
    EXPECT_EQ(player.play().hand().held(), lever) << "the first hand stays";
    player.press();
    player.frames(20);
    EXPECT_EQ(player.play().secondHand().held(), lever) << "both hold the same thing";
    auto const inputs = player.session().inputs();
    ASSERT_FALSE(inputs.empty());
    EXPECT_EQ(inputs.back().hand, 1);
    player.release();
    player.letGo(SDLK_g);
    player.frames(3);
    EXPECT_FALSE(player.play().hand().held().valid());
    EXPECT_FALSE(player.play().secondHand().held().valid());
}

TEST_F(KeysAlone, HaveTwoHands) {
    ObjectId const lever = holdTheLever();
    ASSERT_EQ(player.play().hand().held(), lever);
    player.hold(SDLK_g);
    player.letGo(SDLK_RETURN);
    player.frames(3);
    EXPECT_EQ(player.play().hand().held(), lever) << "the first hand stays";
    player.hold(SDLK_RETURN);
    player.frames(20);
    EXPECT_EQ(player.play().secondHand().held(), lever) << "both hold the same thing";
    player.letGo(SDLK_RETURN);
    player.letGo(SDLK_g);
    player.frames(3);
    EXPECT_FALSE(player.play().hand().held().valid());
    EXPECT_FALSE(player.play().secondHand().held().valid());
}

// The direction that is held down, as well as each press, is that of the buttons that the player chose.
TEST_F(KeysAlone, HaveTheButtonsThatThePlayerChose) {
    using render::padKey;
    player.open(levelsFolder() / "first/1-first-contact.json");
    KeyBindings& keys = player.app().context().keys;
    auto const& all = keys.commands();
    auto const right = std::find_if(all.begin(), all.end(),
                                    [](CommandInfo const* command) { return command->id == "move-right"; });
    ASSERT_NE(right, all.end());
    ASSERT_FALSE(keys.bind(**right, {padKey(SDL_CONTROLLER_BUTTON_PADDLE1)}));
    go({0, 1});
    auto const movedBy = [&](SDL_GameControllerButton button) {
        double const before = player.play().keyPointer().at().x;
        player.hold(padKey(button));
        player.frames(40);
        player.letGo(padKey(button));
        return player.play().keyPointer().at().x - before;
    };
    EXPECT_EQ(movedBy(SDL_CONTROLLER_BUTTON_DPAD_RIGHT), 0);
    EXPECT_GT(movedBy(SDL_CONTROLLER_BUTTON_PADDLE1), 3 * gridStep);
    keys.reset();
}

} // namespace
} // namespace key_pointer_test
} // namespace trembler::ui::test
