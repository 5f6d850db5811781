// All engines: a missing one is rejected by name, and gears work with each.
#include "physics/dynamics/core/dynamics_resolver.hpp"
#include "tests/physics/dynamics/scene.hpp"

namespace trembler::test {
namespace {

constexpr DynamicsEngine notThere{.text{.name = "No Dynamics",
                                        .effect = "dynamics",
                                        .level = "absent",
                                        .work = "Nothing.",
                                        .rank = -1}, // the cheapest, but it must not be picked
                                  .missing = "this program was built without it"};

TEST(EngineChoice, AMissingOneIsRefusedAndTheOthersWork) {
    Registry registry;
    registerScene(registry);
    registry.component<DynamicsResolver>(notThere);
    World world(registry, {});
    try {
        world.setDetail("dynamics", "absent");
        ADD_FAILURE() << "taken";
    } catch (std::invalid_argument const& error) {
        EXPECT_STREQ(error.what(), "dynamics=absent is not available: this program was built without it");
    }
    EXPECT_THROW(
        World(registry, WorldOptions{.threads = 1, .detail = {{"dynamics", "absent"}}, .periods = {}}),
        std::invalid_argument);
    ObjectId const ball = world.store().create("ball");
    world.store().column<Shape>().set(ball, Shape{{circlePiece(0.1)}});
    world.store().column<Position>().set(ball, Position{{0, 1}});
    world.store().column<Velocity>().set(ball, Velocity{{1, 0}});
    world.start();
    world.step();
    world.step();
    EXPECT_NEAR(world.find<Position>(ball)->value.x, 2 * frameDuration, 1e-6);
}

} // namespace
} // namespace trembler::test
