// Freely moving magnets in whole frames: total momentum and angular momentum are conserved.
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/magnetism/properties.hpp"
#include "physics/register_physics.hpp"
#include "runtime/placement.hpp"
#include "runtime/world/world.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace trembler {
namespace {

struct Kit {
    Registry registry;
    World world;
    Kit() : registry(), world((registerEverything(registry), registry)) {}

    ObjectId bar(std::string const& name, Vec2 at, double angle, double mass, double strength) {
        Store& store = world.store();
        ObjectId const id = store.create(name);
        store.column<Shape>().set(id, {{boxPiece(0.2, 0.05)}});
        store.column<Mass>().set(id, {mass});
        store.column<Position>().set(id, {at});
        store.column<Rotation>().set(id, {angle});
        store.column<MagneticStrength>().set(id, {strength, 0});
        store.column<MagneticPoles>().set(id, {PoleSet::both, {0.09, 0}, {-0.09, 0}});
        return id;
    }
    [[nodiscard]] Vec2 momentum(ObjectId id) const {
        return world.find<Mass>(id)->value * world.find<Velocity>(id)->value;
    }
};

TEST(MagnetMotion, AFreePairKeepsItsMomentum) {
    Kit kit;
    ObjectId const a = kit.bar("a", {0, 0}, 0.4, 1, 2000);
    ObjectId const b = kit.bar("b", {1, 0.2}, 0.1, 3, 2000);
    kit.world.start();
    double fastest = 0;
    for (int frame = 0; frame < 60; ++frame) {
        kit.world.step();
        fastest = std::max(fastest, length(kit.momentum(a)));
        EXPECT_LT(length(kit.momentum(a) + kit.momentum(b)), 1e-4 * fastest + 1e-6) << frame;
    }
    EXPECT_GT(fastest, 0.05) << "they must have moved";
}

TEST(MagnetMotion, OppositePolesAttractAndLikePolesRepel) {
    for (bool const like : {false, true}) {
        Kit kit;
        ObjectId const a = kit.bar("a", {0, 0}, 0, 1, 2000);
        ObjectId const b = kit.bar("b", {0.6, 0}, like ? pi : 0, 1, 2000);
        kit.world.start();
        for (int frame = 0; frame < 10; ++frame) {
            kit.world.step();
        }
        double const apart = kit.world.find<Position>(b)->value.x - kit.world.find<Position>(a)->value.x;
        if (like) {
            EXPECT_GT(apart, 0.601);
        } else {
            EXPECT_LT(apart, 0.599);
        }
    }
}

// A compass needle in the field of a fixed magnet turns until it points along it.
TEST(MagnetMotion, ANeedleTurnsTowardsAMagnet) {
    Kit kit;
    ObjectId const magnet = kit.bar("magnet", {0, 0}, 0, 1, 20000);
    ObjectId const needle = kit.bar("needle", {1, 0}, 1.0, 1, 200);
    Store& store = kit.world.store();
    store.column<Fixed>().set(magnet, {});
    store.column<Damping>().set(needle, {5, 5});
    kit.world.start();
    for (int frame = 0; frame < 240; ++frame) {
        kit.world.step();
    }
    EXPECT_LT(std::abs(std::sin(kit.world.find<Rotation>(needle)->angle)), 0.2);
    EXPECT_GT(std::cos(kit.world.find<Rotation>(needle)->angle), 0) << "its south towards the magnet's north";
    EXPECT_EQ(kit.world.find<Position>(magnet)->value, (Vec2{0, 0}));
}

// A ball of radius r and mass m that rolls to and fro below a magnet has the energy E = 3/4 m v² + k x²/2.
// Its spin v/r is braked by the torque L k (r²/2) v/r, where L is magneticLag, so E falls at the mean rate of
// L k/(3 m).
TEST(MagnetMotion, ABallThatRollsBelowAMagnetComesToRest) {
    Kit kit;
    Store& store = kit.world.store();
    constexpr double radius = 0.1;
    constexpr double mass = 10;
    ObjectId const magnet = store.create("magnet");
    store.column<Shape>().set(magnet, {{boxPiece(4, 0.2)}});
    store.column<Position>().set(magnet, {{0, 0.1}});
    store.column<Fixed>().set(magnet, {});
    store.column<Friction>().set(magnet, {1});
    store.column<MagneticStrength>().set(magnet, {60000, 0});
    store.column<MagneticPoles>().set(magnet, {PoleSet::north, {0, 0.1}, {}});
    ObjectId const ball = store.create("ball");
    store.column<Shape>().set(ball, {{circlePiece(radius)}});
    store.column<Mass>().set(ball, {mass});
    store.column<Position>().set(ball, {{0.06, -radius}});
    store.column<Friction>().set(ball, {1});
    store.column<MagneticStrength>().set(ball, {0, 10000});
    for (ObjectId const id : {magnet, ball}) {
        store.column<Magnet>().set(id, {});
        store.column<Restitution>().set(id, {0});
    }
    kit.world.start();
    // The greatest speed within half a second, which is at least half a swing.
    auto const fastest = [&] {
        double found = 0;
        for (int frame = 0; frame < 30; ++frame) {
            kit.world.step();
            found = std::max(found, length(kit.world.find<Velocity>(ball)->value));
        }
        return found;
    };
    double const begin = fastest();
    double const rate = kit.world.find<MagneticForce>()->rates.back().rate; // the ball's
    for (int i = 0; i < 2; ++i) {
        fastest();
    }
    double const end = fastest(); // 1.5 s later
    ASSERT_GT(begin, 0.1);
    EXPECT_NEAR(2 * std::log(begin / end), 1.5 * magneticLag * rate * rate / 3,
                0.3 * 2 * std::log(begin / end))
        << "ω_M = " << rate;
    for (int i = 0; i < 40; ++i) {
        fastest();
    }
    EXPECT_LT(fastest(), 1e-3);
    EXPECT_NEAR(kit.world.find<Position>(ball)->value.x, 0, 0.005);
}

} // namespace
} // namespace trembler
