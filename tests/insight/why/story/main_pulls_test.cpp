#include "insight/why/story/main_pulls.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/magnetism/properties.hpp"
#include "tests/support/game_data.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace trembler::insight {
namespace main_pulls_test {
namespace {

/// A world whose magnetic actions the test sets. One step is one frame.
class Scene {
public:
    Scene() : world_(gameData().registry, {}) {
        for (char const* const name : {"spoke 1", "spoke 2", "spoke 3", "coil", "base", "ball"}) {
            (void)world_.store().create(name);
        }
        world_.start();
    }
    void step(std::vector<MagneticForce::Action> actions) {
        world_.step();
        world_.store().slot<MagneticForce>().value().actions = std::move(actions);
        pulls.look(world_, tied);
    }
    MagneticForce::Action action(char const* object, char const* by, double force, std::uint64_t event) {
        return {world_.store().find(object), world_.store().find(by), std::abs(force), force < 0,
                EventId{event}};
    }
    void weigh(char const* object, double kilograms) {
        world_.store().column<Mass>().set(world_.store().find(object), {kilograms});
    }
    [[nodiscard]] std::vector<std::uint64_t> on(char const* object, std::uint64_t frame) const {
        std::vector<std::uint64_t> events;
        for (MainPulls::Pull const& pull : pulls.on(object, frame)) {
            events.push_back(pull.event.value);
        }
        std::sort(events.begin(), events.end());
        return events;
    }

    MainPulls pulls;
    MainPulls::Groups const tied{{"spoke 1", 0}, {"spoke 2", 0}, {"spoke 3", 0}};

private:
    World world_;
};

using Events = std::vector<std::uint64_t>;

TEST(MainPulls, AreTheGreatestPullAndPushOnABody) {
    Scene scene;
    scene.step({scene.action("spoke 1", "coil", 300, 1), scene.action("spoke 2", "coil", -200, 2),
                scene.action("spoke 3", "coil", 40, 3), scene.action("spoke 3", "spoke 1", 900, 4),
                scene.action("spoke 2", "base", 50, 5), scene.action("spoke 1", "base", -1, 6),
                scene.action("ball", "coil", 0.01, 7)});
    EXPECT_EQ(scene.on("spoke 3", 1), Events{}) << "a force acts in the frame after it was computed";
    EXPECT_EQ(scene.on("spoke 3", 2), (Events{1, 2, 5})) << "wherever on the body they act";
    EXPECT_EQ(scene.on("ball", 2), Events{7}) << "however weak, as nothing else moves it";
    EXPECT_EQ(scene.on("coil", 2), Events{});
    EXPECT_TRUE(scene.pulls.isMain(EventId{2}));
    EXPECT_FALSE(scene.pulls.isMain(EventId{3}));
    EXPECT_FALSE(scene.pulls.isMain(EventId{4})) << "a body does not move itself";
}

TEST(MainPulls, AreNoneThatAreWeakBesideAnotherMagnetOrForTheMass) {
    Scene scene;
    scene.step({scene.action("spoke 1", "coil", 400, 1), scene.action("spoke 2", "base", 10, 2)});
    scene.step({scene.action("spoke 2", "base", 10, 2)});
    EXPECT_EQ(scene.on("spoke 3", 2), Events{1});
    EXPECT_EQ(scene.on("spoke 3", 3), (Events{1, 2})) << "when the coil is off, the base magnet matters";
    scene.weigh("ball", 5);
    scene.step({scene.action("ball", "base", 0.01, 3)});
    EXPECT_EQ(scene.on("ball", 4), Events{});
    EXPECT_FALSE(scene.pulls.isMain(EventId{3}));
}

TEST(MainPulls, AreThoseOfTheFrameBefore) {
    Scene scene;
    EXPECT_TRUE(scene.pulls.empty());
    scene.step({scene.action("spoke 1", "coil", 300, 1)});
    scene.step({scene.action("spoke 1", "coil", 300, 1), scene.action("spoke 2", "coil", 400, 2)});
    scene.step({});
    scene.step({scene.action("spoke 3", "coil", 100, 3)});
    EXPECT_EQ(scene.on("spoke 1", 2), Events{1});
    EXPECT_EQ(scene.on("spoke 1", 3), Events{2});
    EXPECT_TRUE(scene.pulls.on("spoke 1", 3).front().acting);
    EXPECT_EQ(scene.on("spoke 1", 4), Events{2}) << "by its momentum";
    EXPECT_FALSE(scene.pulls.on("spoke 1", 4).front().acting);
    EXPECT_EQ(scene.on("spoke 1", 5), Events{3});
}

} // namespace
} // namespace main_pulls_test
} // namespace trembler::insight
