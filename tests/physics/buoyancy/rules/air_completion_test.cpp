// The objects on which air acts although they do not state it.
#include "physics/buoyancy/rules/air_completion.hpp"
#include "tests/physics/buoyancy/pool.hpp"

#include <gtest/gtest.h>

namespace trembler::test {
namespace {

TEST(AirCompletion, ChoosesLightMovableObjects) {
    Pool pool;
    ObjectId const balloon = pool.body("balloon", circlePiece(0.2), {0, 0}, 11.9);
    ObjectId const cork = pool.body("cork", circlePiece(0.2), {1, 0}, 12.1);
    ObjectId const still = pool.body("still", circlePiece(0.2), {2, 0}, 1);
    pool.give(still, Fixed{});
    ObjectId const gas = pool.liquid("gas", boxPiece(1, 1), {4, 0}, 1);
    ObjectId const denied = pool.body("denied", circlePiece(0.2), {6, 0}, 1);
    pool.give(denied, Without{{"in_air"}});
    ObjectId const stated = pool.body("stated", circlePiece(0.2), {8, 0}, 500);
    pool.give(stated, InAir{});
    pool.run(1);
    auto const inAir = [&](ObjectId id) { return pool.world->find<InAir>(id) != nullptr; };
    EXPECT_TRUE(inAir(balloon));
    EXPECT_TRUE(inAir(stated));
    for (ObjectId const id : {cork, still, gas, denied}) {
        EXPECT_FALSE(inAir(id)) << pool.world->store().nameOf(id);
    }
}

} // namespace
} // namespace trembler::test
