// A tool for the player's hand, against the laws of momentum.
#include "physics/dynamics/properties/body.hpp"
#include "runtime/input/input_resolver.hpp"
#include "tests/lua/support/bundled_mods.hpp"

#include <gtest/gtest.h>

namespace trembler::lua {
namespace {

struct GunWorld {
    GameData const* game = gameWith({"gravity-gun"});
    std::unique_ptr<World> world = worldOf(*game, R"(
        {"name": "gun", "part": "gravity gun", "at": [0, 0]},
        {"name": "ball", "part": "steel ball", "at": [2, 0.1]},
        {"name": "behind", "part": "wooden ball", "at": [-1, 0]},
        {"name": "aside", "part": "wooden ball", "at": [0.5, 1]})");

    void hand(PlayerInput::Kind kind) {
        world->feed(
            PlayerInput{.kind = kind, .object = world->store().find("gun"), .other = {}, .at = {0, 0}});
    }
    [[nodiscard]] Vec2 momentumOf(std::string const& name) const {
        return of<Velocity>(*world, name).value * of<Mass>(*world, name).value;
    }
};

TEST(GravityGunMod, DrawsInWhatLiesBeforeItAndKeepsItAtItsMuzzle) {
    GunWorld gun;
    stepFrames(*gun.world, 30);
    EXPECT_EQ(of<Position>(*gun.world, "ball").value.x, 2) << "nobody holds it";
    gun.hand(PlayerInput::Kind::grab);
    stepFrames(*gun.world, 240);
    EXPECT_EQ(errorsOf(*gun.game), "");
    Vec2 const way = of<Position>(*gun.world, "ball").value - of<Position>(*gun.world, "gun").value;
    EXPECT_NEAR(way.x, 0.6, 0.005);
    EXPECT_NEAR(way.y, 0, 0.005);
    EXPECT_NEAR(of<Position>(*gun.world, "behind").value.x, -1, 1e-9);
    EXPECT_NEAR(of<Position>(*gun.world, "aside").value.x, 0.5, 1e-9);
}

TEST(GravityGunMod, HurlsWithItsSpeedAndRecoilsWithTheSameMomentum) {
    GunWorld gun;
    gun.hand(PlayerInput::Kind::grab);
    stepFrames(*gun.world, 240);
    ASSERT_NEAR(length(of<Velocity>(*gun.world, "ball").value), 0, 1e-3) << "it hangs still";
    gun.hand(PlayerInput::Kind::release);
    stepFrames(*gun.world, 4);
    EXPECT_EQ(errorsOf(*gun.game), "");
    EXPECT_NEAR(of<Velocity>(*gun.world, "ball").value.x, 9, 0.01);
    Vec2 const sum = gun.momentumOf("ball") + gun.momentumOf("gun");
    EXPECT_NEAR(sum.x, 0, 0.01 * gun.momentumOf("ball").x);
    EXPECT_NEAR(sum.y, 0, 0.01 * gun.momentumOf("ball").x);
    stepFrames(*gun.world, 30);
    EXPECT_NEAR(of<Velocity>(*gun.world, "ball").value.x, 9, 0.01) << "once";
}

} // namespace
} // namespace trembler::lua
