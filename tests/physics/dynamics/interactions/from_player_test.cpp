// The player's hand: grabbing, dragging and releasing objects.
#include "physics/dynamics/interactions/from_player.hpp"
#include "tests/physics/dynamics/scene.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace trembler::test {
namespace from_player_test {
namespace {

class Hand : public OnEveryEngine {};
TREMBLER_ON_EVERY_ENGINE(Hand);

PlayerInput input(PlayerInput::Kind kind, ObjectId object, Vec2 at) {
    return {.kind = kind, .object = object, .other = {}, .at = at};
}

Vec2 held(Scene const& scene, ObjectId id, Vec2 local) {
    return scene.at(id) + rotated(local, scene.angle(id));
}

TEST_P(Hand, PullsTheGrabbedPointToItsPlaceWithoutOvershoot) {
    for (double const mass : {0.01, 1.0, 1000.0}) {
        Scene scene;
        scene.gravity = 0;
        ObjectId const bar = scene.body("bar", boxPiece(2, 0.1), {0, 0});
        scene.give(bar, Mass{mass});
        scene.give(scene.fixed("strength", boxPiece(0.1, 0.1), {9, 9}), Hands{1e6});
        scene.run(1);
        scene.world->feed(input(PlayerInput::Kind::grab, bar, {0.9, 0}));
        scene.run(1);
        scene.world->feed(input(PlayerInput::Kind::move, bar, {0.9, 1}));
        double highest = 0;
        for (int frame = 0; frame < 120; ++frame) {
            scene.run(1);
            highest = std::max(highest, held(scene, bar, {0.9, 0}).y);
        }
        EXPECT_NEAR(length(held(scene, bar, {0.9, 0}) - Vec2{0.9, 1}), 0, 0.01) << mass;
        EXPECT_LT(highest, 1.05) << mass;
    }
}

TEST_P(Hand, HoldsAgainstGravityAndReleases) {
    Scene scene({.trace = true});
    ObjectId const box = scene.body("box", boxPiece(0.4, 0.4), {0, 2});
    scene.run(1);
    scene.world->feed(input(PlayerInput::Kind::grab, box, {0, 2.1}));
    scene.run(300);
    EXPECT_NEAR(held(scene, box, {0, 0.1}).y, 2.1 - 9.81 / 144, 0.01); // hangs on a spring of 12 rad/s
    EXPECT_EQ(scene.dynamics(), Activity::asleep);
    scene.world->feed(input(PlayerInput::Kind::release, box, {}));
    scene.run(32);
    EXPECT_LT(scene.at(box).y, 1);
    Tracer const& tracer = *scene.world->tracer();
    bool led = false;
    for (Event const& event : tracer.events()) {
        for (EventId const cause : event.causes) {
            led = led || (event.event == "addForceToPoint" && tracer.find(cause)->event == "grabbed");
        }
    }
    EXPECT_TRUE(led);
}

/// The speed (m/s) to which one hand, in a world that states no strength, brings a box of that mass (kg) in
/// three frames, upwards from rest. Its target is so far away that it pulls as hard as it can.
double speedAfterThreeFrames(double mass, double gravity) {
    Scene scene;
    scene.gravity = gravity;
    ObjectId const box = scene.body("box", boxPiece(0.4, 0.4), {0, 0});
    scene.give(box, Mass{mass});
    scene.run(1);
    scene.world->feed(input(PlayerInput::Kind::grab, box, scene.at(box)));
    scene.world->feed(input(PlayerInput::Kind::move, box, {0, 1e5}));
    scene.run(1); // the hand takes hold and calls; dynamics gets its force in the next frame
    double const before = scene.velocity(box).y;
    scene.run(3);
    return scene.velocity(box).y - before;
}

TEST_P(Hand, HangsHigherOnTheMoonAndIsAsStrongAsOnEarth) {
    Scene scene;
    scene.gravity = 1.62;
    ObjectId const box = scene.body("box", boxPiece(0.4, 0.4), {0, 2});
    scene.run(1);
    scene.world->feed(input(PlayerInput::Kind::grab, box, {0, 2.1}));
    scene.run(300);
    EXPECT_NEAR(held(scene, box, {0, 0.1}).y, 2.1 - 1.62 / 144, 0.01);
    double const strength = Hands{}.strength;
    for (double const gravity : {0.0, 1.62, 9.81}) {
        EXPECT_NEAR(speedAfterThreeFrames(100, gravity), (strength / 100 - gravity) * 3 * frameDuration, 0.01)
            << gravity;
    }
}

TEST_P(Hand, PullsAHeavyObjectNoHarderThanALightOne) {
    double const strength = Hands{}.strength;
    for (double const mass : {30.0, 300.0, 3000.0}) {
        double const force = speedAfterThreeFrames(mass, 0) * mass / (3 * frameDuration);
        EXPECT_NEAR(force, strength, 0.001 * strength) << mass;
    }
}

TEST_P(Hand, DoesNotMoveFixedObjectsAndReleasesRemovedOnes) {
    Scene scene;
    ObjectId const wall = scene.fixed("wall", boxPiece(1, 1), {0, 0});
    ObjectId const ball = scene.ball({5, 0});
    scene.run(1);
    scene.world->feed(input(PlayerInput::Kind::grab, wall, {0, 0}));
    scene.world->feed(input(PlayerInput::Kind::move, wall, {3, 3}));
    scene.run(30);
    EXPECT_EQ(scene.at(wall), (Vec2{0, 0}));
    scene.world->feed(input(PlayerInput::Kind::grab, ball, scene.at(ball)));
    scene.world->feed(input(PlayerInput::Kind::remove, ball, {}));
    scene.run(10);
    EXPECT_FALSE(scene.world->store().alive(ball));
}

TEST_P(Hand, WithoutStrengthDoesNothingAtAll) {
    Scene scene;
    scene.gravity = 0;
    ObjectId const box = scene.body("box", boxPiece(0.4, 0.4), {0, 0});
    scene.give(box, AngularVelocity{3});
    scene.give(scene.fixed("strength", boxPiece(0.1, 0.1), {9, 9}), Hands{0});
    scene.run(1);
    scene.world->feed(input(PlayerInput::Kind::grab, box, {0, 0}));
    scene.world->feed(input(PlayerInput::Kind::move, box, {1, 0}));
    scene.run(60);
    EXPECT_NEAR(scene.at(box).x, 0, 1e-9);
    EXPECT_NEAR(scene.angle(box), 3 * 61 * frameDuration, 0.01) << "it does not brake either";
}

/// How far (m) the hands lift a box of that mass (kg) off the floor, one at its middle or both at its ends.
/// `strength`: of each hand, N; left out: the world does not state it.
double lifted(double mass, int hands, double gravity, std::optional<double> strength = {}) {
    Scene scene;
    scene.gravity = gravity;
    scene.fixed("floor", boxPiece(20, 1), {0, -0.5});
    ObjectId const box = scene.body("box", boxPiece(1, 0.4), {0, 0.2});
    scene.give(box, Mass{mass});
    ObjectId const world = scene.fixed("strength", boxPiece(0.1, 0.1), {9, 9});
    if (strength) {
        scene.give(world, Hands{*strength});
    }
    scene.run(1);
    for (std::uint8_t hand = 0; hand < hands; ++hand) {
        double const x = hands == 1 ? 0 : (hand == 0 ? -0.4 : 0.4);
        PlayerInput grab = input(PlayerInput::Kind::grab, box, {x, 0.2});
        grab.hand = hand;
        scene.world->feed(grab);
        PlayerInput move = input(PlayerInput::Kind::move, box, {x, 1.7});
        move.hand = hand;
        scene.world->feed(move);
    }
    scene.run(240);
    return scene.at(box).y - 0.2;
}

TEST_P(Hand, IsAsStrongAsTheWorldStatesAndTwoLiftTwiceAsMuch) {
    EXPECT_GT(lifted(45, 1, 9.81, 500), 1);
    EXPECT_LT(lifted(60, 1, 9.81, 500), 0.01) << "500 N lift 51 kg";
    EXPECT_GT(lifted(60, 2, 9.81, 500), 1);
    EXPECT_LT(lifted(110, 2, 9.81, 500), 0.01);
    EXPECT_GT(lifted(280, 1, 1.62, 500), 1) << "on the Moon";
    EXPECT_LT(lifted(330, 1, 1.62, 500), 0.01);
}

TEST_P(Hand, HasAStrengthInAWorldThatStatesNone) {
    double const most = Hands{}.strength / 9.81; // kg that it holds up on Earth
    EXPECT_GT(lifted(0.9 * most, 1, 9.81), 0.5);
    EXPECT_LT(lifted(1.1 * most, 1, 9.81), 0.01);
    EXPECT_GT(lifted(1.8 * most, 2, 9.81), 0.5) << "two hands lift what is too heavy for one";
    EXPECT_LT(lifted(2.2 * most, 2, 9.81), 0.01);
    EXPECT_GT(lifted(1.1 * most, 1, 1.62), 0.5) << "on the Moon";
}

TEST(HandStrength, IsTheOneThatItsTextStates) {
    std::string const text{Hands::text.meaning};
    EXPECT_NE(text.find(fmt::format("{:.0f} N", Hands{}.strength)), std::string::npos) << text;
    EXPECT_NE(text.find(fmt::format("{:.0f} kg", Hands{}.strength / 9.81)), std::string::npos) << text;
}

TEST_P(Hand, TheSecondHoldsSomethingElseAndLetsGoByItself) {
    Scene scene;
    scene.gravity = 0;
    ObjectId const a = scene.body("a", boxPiece(0.4, 0.4), {-2, 0});
    ObjectId const b = scene.body("b", boxPiece(0.4, 0.4), {2, 0});
    scene.run(1);
    auto const feed = [&](PlayerInput::Kind kind, ObjectId object, Vec2 at, std::uint8_t hand) {
        PlayerInput one = input(kind, object, at);
        one.hand = hand;
        scene.world->feed(one);
    };
    auto const before = scene.world->stateHash();
    feed(PlayerInput::Kind::grab, a, {-2, 0}, 0);
    feed(PlayerInput::Kind::grab, b, {2, 0}, 1);
    feed(PlayerInput::Kind::move, a, {-2, 1}, 0);
    feed(PlayerInput::Kind::move, b, {2, -1}, 1);
    scene.run(120);
    EXPECT_NE(scene.world->stateHash(), before);
    EXPECT_NEAR(scene.at(a).y, 1, 0.01);
    EXPECT_NEAR(scene.at(b).y, -1, 0.01);
    EXPECT_EQ(scene.world->find<trembler::Hand>()->object, a);
    EXPECT_EQ(scene.world->find<SecondHand>()->grip.object, b);
    auto const held = scene.world->stateHash();
    feed(PlayerInput::Kind::release, b, {}, 1);
    scene.run(1);
    EXPECT_FALSE(scene.world->find<SecondHand>()->grip.object.valid());
    EXPECT_EQ(scene.world->find<trembler::Hand>()->object, a);
    EXPECT_NE(scene.world->stateHash(), held);
}

} // namespace
} // namespace from_player_test
} // namespace trembler::test
