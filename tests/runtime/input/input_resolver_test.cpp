// The player's inputs reach the world through one resolver, in the frame after they were fed.
#include "runtime/input/input_resolver.hpp"
#include "runtime/population/population_resolver.hpp"
#include "runtime/world/world.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace trembler {
namespace {

using Kind = PlayerInput::Kind;

struct Scene {
    Registry registry;
    std::unique_ptr<World> world;
    ObjectId crate;
    ObjectId wheel;
    Scene() {
        registerRuntime(registry);
        world = std::make_unique<World>(
            registry, WorldOptions{.threads = 1, .detail = {}, .periods = {}, .trace = true});
        crate = world->store().create("crate");
        world->store().column<Position>().set(crate, {{2, 1}});
        world->store().column<Rotation>().set(crate, {pi / 2});
        wheel = world->store().create("wheel");
        world->store().column<Position>().set(wheel, {{5, 5}});
        world->start();
    }
    void feed(Kind kind, ObjectId object, Vec2 at = {}, ObjectId other = {}) {
        world->feed({.kind = kind, .object = object, .other = other, .at = at});
    }
    [[nodiscard]] Hand const& hand() const { return *world->find<Hand>(); }
    [[nodiscard]] std::vector<std::string> events() const {
        std::vector<std::string> all;
        for (Event const& event : world->tracer()->events()) {
            all.push_back(event.event);
        }
        return all;
    }
};

TEST(InputResolver, HoldsTheGrabbedPointInTheObjectsOwnFrame) {
    Scene scene;
    scene.feed(Kind::grab, scene.crate, {2, 3});
    EXPECT_FALSE(scene.hand().object.valid()) << "not before the next frame";
    scene.world->step();
    EXPECT_EQ(scene.hand().object, scene.crate);
    EXPECT_NEAR(scene.hand().localPoint.x, 2,
                1e-15); // 2 m above it, in the frame of an object turned by a quarter
    EXPECT_NEAR(scene.hand().localPoint.y, 0, 1e-15);
    EXPECT_EQ(scene.hand().target, (Vec2{2, 3}));
    EXPECT_TRUE(static_cast<bool>(scene.hand().event));
}

TEST(InputResolver, MovesAndReleasesTheHeldObject) {
    Scene scene;
    scene.feed(Kind::move, {}, {9, 9}); // an empty hand: ignored
    scene.feed(Kind::release, {});
    scene.feed(Kind::grab, scene.wheel, {5, 5}); // an object without a rotation
    scene.feed(Kind::move, {}, {6, 7});
    scene.world->step();
    EXPECT_EQ(scene.hand().object, scene.wheel);
    EXPECT_EQ(scene.hand().target, (Vec2{6, 7}));
    scene.feed(Kind::release, {});
    scene.world->step();
    EXPECT_FALSE(scene.hand().object.valid());
    EXPECT_EQ(scene.events(), (std::vector<std::string>{"grabbed", "released"}));
    Event const& released = scene.world->tracer()->events().back();
    EXPECT_EQ(released.causes, std::vector{scene.world->tracer()->events().front().id});
}

TEST(InputResolver, OffersCutsAndRemovalsForOneFrame) {
    Scene scene;
    scene.feed(Kind::cut, scene.crate, {}, scene.wheel);
    scene.world->step();
    PlayerCommands const& commands = *scene.world->find<PlayerCommands>();
    ASSERT_EQ(commands.cuts.size(), 1U);
    EXPECT_EQ(commands.cuts[0].a, scene.crate);
    EXPECT_EQ(commands.cuts[0].b, scene.wheel);
    scene.world->step();
    EXPECT_TRUE(commands.cuts.empty());
}

TEST(InputResolver, SleepsWhileThePlayerDoesNothing) {
    Scene scene;
    for (int i = 0; i < 3; ++i) {
        scene.world->store().column<Position>().set(scene.crate, {{1.0 * i, 0}});
        scene.world->step();
    }
    for (ComponentStatus const& status : scene.world->status()) {
        if (status.info->text.name == "Player") {
            EXPECT_EQ(status.updates, 0U);
        }
    }
}

TEST(InputResolver, IgnoresRemovedObjectsAndObjectsWithoutPosition) {
    Scene scene;
    double const nan = std::numeric_limits<double>::quiet_NaN();
    scene.feed(Kind::grab, ObjectId{77, 0}, {1, 1});
    scene.feed(Kind::grab, scene.crate, {nan, 1});
    scene.world->step();
    EXPECT_FALSE(scene.hand().object.valid());
    scene.feed(Kind::grab, scene.crate, {1, 1});
    scene.feed(Kind::move, {}, {0, std::numeric_limits<double>::infinity()});
    scene.world->step();
    EXPECT_EQ(scene.hand().target, (Vec2{1, 1}));
}

TEST(PlayerInput, HasANameForEveryKind) {
    EXPECT_EQ(std::size(playerInputNames), static_cast<std::size_t>(Kind::remove) + 1);
    EXPECT_EQ(playerInputNames[static_cast<std::size_t>(Kind::cut)], "cut");
}

} // namespace
} // namespace trembler
