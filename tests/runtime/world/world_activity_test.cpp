// Absent, asleep and active components; periods; components that are constructed and destroyed with the
// objects that activate them.
#include "runtime/population/population_resolver.hpp"
#include "tests/runtime/world/heat.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace world_activity_test {
namespace {

using namespace heat;

ObjectId hotThing(World& world, std::string const& name, double heat) {
    ObjectId const id = world.store().create(name);
    world.store().column<Heat>().set(id, {heat});
    return id;
}
void steps(World& world, int n) {
    for (int i = 0; i < n; ++i) {
        world.step();
    }
}

TEST(WorldActivity, ComponentsThatNoObjectActivatesAreNotConstructed) {
    Registry registry;
    registry.component<Stove>();
    registry.component<ExactGlow>();
    registry.component<HeatFromFuel>();
    World world(registry);
    world.start();
    steps(world, 3);
    for (ComponentStatus const& status : world.status()) {
        EXPECT_EQ(status.activity, Activity::absent) << status.info->text.name;
        EXPECT_EQ(status.choice.reason, ChoiceReason::noObjects) << status.info->text.name;
        EXPECT_EQ(status.updates, 0U);
    }
    EXPECT_EQ(world.find<Glow>(), nullptr); // not even its slot was made
}

TEST(WorldActivity, NeedsAllRequiresEveryPropertyAndTheResolver) {
    Registry registry;
    registry.component<Stove>();
    registry.component<HeatFromFuel>();
    World world(registry);
    ObjectId const log = world.store().create("log");
    world.store().column<Fuel>().set(log, {5});
    world.start();
    world.step();
    EXPECT_EQ(statusOf(world, "Heat <- Fuel").activity, Activity::absent) << "nothing has heat";
    world.store().column<Heat>().set(log, {0});
    world.step(); // activated at the end of the resolvers' phase
    EXPECT_EQ(statusOf(world, "Heat <- Fuel").activity, Activity::active);
    EXPECT_EQ(statusOf(world, "Stove").activity, Activity::asleep)
        << "constructed, but its first turn is in the next frame";
    world.step();
    EXPECT_EQ(statusOf(world, "Stove").activity, Activity::active);
    EXPECT_EQ(statusOf(world, "Stove").updates, 1U);
}

TEST(WorldActivity, AComponentSleepsUntilItsReadsChange) {
    Registry registry;
    registry.component<ExactGlow>();
    World world(registry);
    ObjectId const coal = hotThing(world, "coal", 7);
    world.start();
    EXPECT_EQ(statusOf(world, "Exact Glow").activity, Activity::asleep) << "constructed, no turn yet";
    world.step();
    EXPECT_EQ(statusOf(world, "Exact Glow").activity, Activity::active);
    EXPECT_EQ(world.find<Glow>()->total, 7);
    steps(world, 10);
    EXPECT_EQ(statusOf(world, "Exact Glow").activity, Activity::asleep);
    EXPECT_EQ(statusOf(world, "Exact Glow").updates, 1U);
    world.store().column<Heat>().set(coal, {8});
    world.step();
    EXPECT_EQ(statusOf(world, "Exact Glow").activity, Activity::active);
    EXPECT_EQ(statusOf(world, "Exact Glow").updates, 2U);
    EXPECT_EQ(world.find<Glow>()->total, 8);
}

TEST(WorldActivity, AResolversOwnWritesDoNotKeepItAwake) {
    Registry registry;
    registry.component<Stove>();
    World world(registry);
    hotThing(world, "coal", 1);
    world.start();
    steps(world, 5);
    EXPECT_EQ(world.find<StoveLog>()->advances, 1);
    EXPECT_EQ(statusOf(world, "Stove").activity, Activity::asleep);
}

TEST(WorldActivity, APeriodOfThreeRunsInEveryThirdFrameForThreeFramesTime) {
    Registry registry;
    registry.component<Furnace>();
    World world(registry, {.threads = 1, .detail = {}, .periods = {{"Furnace Resolver", 3}}});
    hotThing(world, "coal", 1);
    world.start();
    std::vector<int> frames;
    std::vector<double> durations;
    int before = 0;
    for (int frame = 1; frame <= 10; ++frame) {
        world.step();
        if (world.find<StoveLog>()->advances != before) {
            before = world.find<StoveLog>()->advances;
            frames.push_back(frame);
            durations.push_back(world.find<StoveLog>()->duration);
        }
    }
    EXPECT_EQ(frames, (std::vector{1, 4, 7, 10}));
    EXPECT_DOUBLE_EQ(durations[0], frameDuration);
    for (std::size_t i = 1; i < durations.size(); ++i) {
        EXPECT_DOUBLE_EQ(durations[i], 3 * frameDuration);
    }
}

// Rates times durations must add up to rate times time for any period.
TEST(WorldActivity, APeriodDoesNotChangeTheSumOfRates) {
    for (int const period : {1, 2, 5}) {
        Registry registry;
        registry.component<Furnace>();
        registry.component<HeatFromFuel>();
        World world(registry, {.threads = 1, .detail = {}, .periods = {{"Furnace", period}}});
        ObjectId const coal = hotThing(world, "coal", 0);
        world.store().column<Fuel>().set(coal, {60});
        world.start();
        steps(world, 1 + 20 * period); // the first advance comes before the first call
        EXPECT_NEAR(world.find<Heat>(coal)->value, 20.0 * period, 1e-9) << period;
        EXPECT_EQ(statusOf(world, "Heat <- Fuel").updates, 1U) << "a held call is made once";
    }
}

TEST(WorldActivity, SleptTimeIsNotIntegratedLater) {
    Registry registry;
    registry.component<Stove>();
    World world(registry);
    ObjectId const coal = hotThing(world, "coal", 1);
    world.start();
    steps(world, 100);
    world.store().column<Heat>().set(coal, {2});
    world.step();
    EXPECT_EQ(world.find<StoveLog>()->advances, 2);
    EXPECT_DOUBLE_EQ(world.find<StoveLog>()->duration, frameDuration);
}

TEST(WorldActivity, ADerivedPropertySetWithAPeriodLagsBehind) {
    Registry registry;
    registry.component<ExactGlow>();
    World world(registry, {.threads = 1, .detail = {}, .periods = {{"Exact Glow DPS", 4}}});
    ObjectId const coal = hotThing(world, "coal", 1);
    world.start();
    std::vector<double> seen;
    for (int frame = 1; frame <= 9; ++frame) {
        world.store().column<Heat>().set(coal, {static_cast<double>(frame)});
        world.step();
        seen.push_back(world.find<Glow>()->total);
    }
    EXPECT_EQ(seen, (std::vector<double>{1, 1, 1, 1, 5, 5, 5, 5, 9}));
}

TEST(WorldActivity, ComponentsAppearAndVanishWithTheirObjectsAndTheirSlotsAreReset) {
    Registry registry;
    registerRuntime(registry);
    registry.component<Furnace>();
    registry.component<ExactGlow>();
    World world(registry);
    world.start();
    steps(world, 2);
    EXPECT_EQ(statusOf(world, "Exact Glow").activity, Activity::absent);
    ObjectId const coal = hotThing(world, "coal", 3);
    world.step();
    EXPECT_EQ(statusOf(world, "Exact Glow").activity, Activity::active);
    steps(world, 2);
    EXPECT_EQ(world.find<Glow>()->total, 3);
    EXPECT_GT(world.find<StoveLog>()->advances, 0);

    world.feed({.kind = PlayerInput::Kind::remove, .object = coal, .other = {}, .at = {}});
    steps(world, 2);
    EXPECT_EQ(statusOf(world, "Exact Glow").activity, Activity::absent);
    EXPECT_EQ(statusOf(world, "Furnace").activity, Activity::absent);
    EXPECT_EQ(world.find<Glow>()->total, 0) << "no component provides it any more";
    EXPECT_EQ(world.find<StoveLog>()->advances, 0);

    hotThing(world, "another", 4);
    steps(world, 2);
    EXPECT_EQ(world.find<Glow>()->total, 4);
}

struct AmbientHeat final : Completion<AmbientHeat, Reads<>, Adds<Heat>> {
    static constexpr CompletionText text{.name = "Ambient heat", .work = "What can burn is warm."};
    using Activation = NeedsAll<Fuel>;
    static void complete(Access& access) { access.add(Heat{}); }
};

TEST(WorldActivity, StartCompletesObjects) {
    Registry registry;
    registry.component<Stove>();
    registry.component<HeatFromFuel>();
    registry.completion<AmbientHeat>();
    World world(registry);
    ObjectId const coal = world.store().create("coal");
    world.store().column<Fuel>().set(coal, {1});
    ObjectId const stone = world.store().create("stone");
    world.start();
    EXPECT_NE(world.find<Heat>(coal), nullptr);
    EXPECT_EQ(world.find<Heat>(stone), nullptr);
    world.step();
    EXPECT_EQ(statusOf(world, "Stove").updates, 1U);
}

// Its power equals the duration of its turn.
struct HeatFromTime final : Interaction<HeatFromTime, HeatRole, Reads<Fuel>> {
    static constexpr ComponentText text{
        .name = "Heat <- Time", .effect = "heat", .level = "", .work = "Reports the time."};
    using Activation = NeedsAll<Fuel, Heat>;
    void apply(Access& access) {
        forEach(
            [&](ObjectId id, Fuel const&) {
                access.call(AddHeat{id, access.duration()});
            },
            access.read<Fuel>());
    }
};

// The behaviour after a sleep depends on the state, not on the length of the sleep.
TEST(WorldActivity, SleptTimeIsNotPartOfTheNextTurn) {
    Registry registry;
    registry.component<Stove>();
    registry.component<HeatFromTime>();
    World world(registry);
    ObjectId const coal = hotThing(world, "coal", 0);
    world.store().column<Fuel>().set(coal, {1});
    world.start();
    steps(world, 10);
    ASSERT_EQ(statusOf(world, "Heat <- Time").updates, 1U) << "it sleeps";
    double const before = world.find<Heat>(coal)->value;
    world.store().column<Fuel>().touch();
    steps(world, 2);
    EXPECT_EQ(statusOf(world, "Heat <- Time").updates, 2U);
    EXPECT_DOUBLE_EQ(world.find<Heat>(coal)->value - before, frameDuration * frameDuration)
        << "the power equals one frame's duration, and it acts for one frame";
}

TEST(WorldActivity, ComponentsThatReadDerivedPropertiesWaitForTheirProvider) {
    Registry registry;
    registry.component<Stove>();
    registry.component<HeatFromGlow>(); // reads Glow, which no component derives here
    World world(registry);
    hotThing(world, "coal", 1);
    world.start();
    steps(world, 2);
    EXPECT_EQ(statusOf(world, "Heat <- Glow").activity, Activity::absent);
    EXPECT_EQ(statusOf(world, "Heat <- Glow").choice.reason, ChoiceReason::noProvider);
    EXPECT_EQ(statusOf(world, "Heat <- Glow").choice.property, &propertyInfo<Glow>());
}

} // namespace
} // namespace world_activity_test
} // namespace trembler
