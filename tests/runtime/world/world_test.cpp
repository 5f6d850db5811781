#include "runtime/population/population_resolver.hpp"
#include "runtime/property/for_each.hpp"
#include "runtime/world/world.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

TEST(World, RemovesObjectsTwoFramesAfterThePlayersInput) {
    Registry registry;
    registerRuntime(registry);
    World world(registry, {.threads = 1, .detail = {}, .periods = {}, .trace = true});
    ObjectId const crate = world.store().create("crate");
    world.store().column<Position>().set(crate, {{1, 2}});
    world.start();
    world.feed({.kind = PlayerInput::Kind::remove, .object = crate, .other = {}, .at = {}});
    world.step();
    EXPECT_TRUE(world.store().alive(crate));
    world.step();
    EXPECT_FALSE(world.store().alive(crate));
    EXPECT_EQ(world.find<Position>(crate), nullptr);
    ASSERT_EQ(world.find<PopulationChanges>()->destroyed.size(), 1U);
    ASSERT_EQ(world.tracer()->events().size(), 3U);
    EXPECT_EQ(world.tracer()->events()[2].event, "destroyed");
    EXPECT_EQ(world.tracer()->chain(world.tracer()->events()[2].id).size(), 3U);
}

} // namespace
} // namespace trembler
