// Interactions and resolvers in a running world: calls that are held while the caller sleeps, calls that are
// carried out exactly once, and calls from many chunks.
#include "runtime/population/population_resolver.hpp"
#include "tests/runtime/world/heat.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace interaction_test {
namespace {

using namespace heat;

ObjectId thing(World& world, std::string const& name, double heat, double fuel = -1) {
    ObjectId const id = world.store().create(name);
    world.store().column<Heat>().set(id, {heat});
    if (fuel >= 0) {
        world.store().column<Fuel>().set(id, {fuel});
    }
    return id;
}
void steps(World& world, int n) {
    for (int i = 0; i < n; ++i) {
        world.step();
    }
}

TEST(InteractionCalls, AreCarriedOutInTheNextFrame) {
    Registry registry;
    registry.component<Furnace>();
    registry.component<HeatFromFuel>();
    World world(registry);
    ObjectId const coal = thing(world, "coal", 0, 60);
    world.start();
    world.step();
    EXPECT_EQ(world.find<Heat>(coal)->value, 0);
    world.step();
    EXPECT_DOUBLE_EQ(world.find<Heat>(coal)->value, 1);
}

TEST(InteractionCalls, AreHeldWhileTheInteractionSleeps) {
    Registry registry;
    registry.component<Furnace>();
    registry.component<HeatFromFuel>();
    World world(registry);
    ObjectId const coal = thing(world, "coal", 0, 60);
    world.start();
    steps(world, 51);
    EXPECT_EQ(statusOf(world, "Heat <- Fuel").updates, 1U);
    EXPECT_EQ(statusOf(world, "Heat <- Fuel").activity, Activity::asleep);
    EXPECT_NEAR(world.find<Heat>(coal)->value, 50, 1e-9);
    world.store().column<Fuel>().set(coal, {0}); // called again: the old call must be replaced
    steps(world, 1);
    double const then = world.find<Heat>(coal)->value;
    steps(world, 10);
    EXPECT_EQ(world.find<StoveLog>()->held, 1);
    EXPECT_EQ(world.find<Heat>(coal)->value, then);
}

// Strikes once for every change of fuel.
struct StrikeFromFuel final : Interaction<StrikeFromFuel, HeatRole, Reads<Fuel>> {
    static constexpr ComponentText text{
        .name = "Strike <- Fuel", .effect = "heat", .level = "", .work = "Strikes."};
    using Activation = NeedsAll<Fuel>;
    void apply(Access& access) {
        forEach([&](ObjectId id, Fuel const&) { access.call(Strike{id, 1}); }, access.read<Fuel>());
    }
};

TEST(InteractionCalls, ThatAreNotHeldAreCarriedOutExactlyOnceForAnyPeriods) {
    for (int const resolverPeriod : {1, 2, 3, 7}) {
        for (int const interactionPeriod : {1, 2, 5}) {
            Registry registry;
            registry.component<Furnace>();
            registry.component<StrikeFromFuel>();
            World world(registry,
                        {.threads = 1,
                         .detail = {},
                         .periods = {{"Furnace", resolverPeriod}, {"Strike <- Fuel", interactionPeriod}}});
            ObjectId const coal = thing(world, "coal", 0, 1);
            world.start();
            for (int frame = 1; frame <= 40; ++frame) {
                if (frame % 3 == 0 && frame <= 30) {
                    world.store().column<Fuel>().set(coal, {1});
                }
                world.step();
            }
            std::uint64_t const applied = statusOf(world, "Strike <- Fuel").updates;
            EXPECT_GT(applied, 3U);
            EXPECT_EQ(world.find<StoveLog>()->onceEver, static_cast<int>(applied))
                << resolverPeriod << ", " << interactionPeriod;
            EXPECT_EQ(world.find<Heat>(coal)->value, static_cast<double>(applied));
        }
    }
}

TEST(InteractionCalls, OfASleepingResolverWakeIt) {
    Registry registry;
    registry.component<Stove>();
    registry.component<StrikeFromFuel>();
    World world(registry);
    ObjectId const coal = thing(world, "coal", 0, 1);
    world.start();
    steps(world, 20);
    EXPECT_EQ(world.find<Heat>(coal)->value, 1);
    int const advances = world.find<StoveLog>()->advances;
    world.store().column<Fuel>().set(coal, {2});
    steps(world, 20);
    EXPECT_EQ(world.find<Heat>(coal)->value, 2);
    EXPECT_EQ(world.find<StoveLog>()->advances, advances + 1);
}

// Makes calls only for objects with fuel left.
struct HeatFromFuelLeft final : Interaction<HeatFromFuelLeft, HeatRole, Reads<Fuel>> {
    static constexpr ComponentText text{
        .name = "Heat <- Fuel left", .effect = "heat", .level = "", .work = "Burns."};
    using Activation = NeedsAll<Fuel>;
    void apply(Access& access) {
        forEach(
            [&](ObjectId id, Fuel const& fuel) {
                if (fuel.rate > 0) {
                    access.call(AddHeat{id, fuel.rate});
                }
            },
            access.read<Fuel>());
    }
};

TEST(InteractionCalls, AnEmptySetOfCallsAfterAnotherDoesNotWakeTheResolver) {
    Registry registry;
    registry.component<Stove>();
    registry.component<HeatFromFuelLeft>();
    World world(registry);
    ObjectId const coal = thing(world, "coal", 0, 0);
    world.start();
    auto const say = [&](double rate) { // a call reaches the stove within two frames or never
        int const before = world.find<StoveLog>()->advances;
        world.store().column<Fuel>().set(coal, {rate});
        steps(world, 2);
        return world.find<StoveLog>()->advances - before;
    };
    steps(world, 5);
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(say(0), 0) << "no calls, as before";
    }
    EXPECT_EQ(statusOf(world, "Heat <- Fuel left").updates, 4U) << "it was applied each time";
    EXPECT_EQ(say(1), 1);
    EXPECT_EQ(world.find<StoveLog>()->held, 1);
    EXPECT_EQ(say(0), 1) << "the held call was withdrawn";
    EXPECT_EQ(world.find<StoveLog>()->held, 0);
    EXPECT_EQ(say(0), 0);
}

struct Ember {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Ember", "ember", "Keeps warm."};
};
struct HeatFromEmber final : Interaction<HeatFromEmber, HeatRole, Reads<Ember>> {
    static constexpr ComponentText text{
        .name = "Heat <- Ember", .effect = "heat", .level = "", .work = "Keeps warm."};
    using Activation = NeedsAll<Ember>;
    void apply(Access& access) {
        forEach([&](ObjectId id, Ember const&) { access.call(AddHeat{id, 1}); }, access.read<Ember>());
    }
};

// A sleeping resolver must wake if one of two interactions is removed with its held calls.
TEST(InteractionCalls, ThatAreHeldAreRemovedWithTheirInteractionAndWakeTheResolver) {
    Registry registry;
    registry.component<Stove>();
    registry.component<HeatFromFuel>();
    registry.component<HeatFromEmber>();
    World world(registry);
    ObjectId const coal = thing(world, "coal", 0, 1);
    world.store().column<Ember>().set(coal, {});
    world.start();
    steps(world, 5);
    EXPECT_EQ(world.find<StoveLog>()->held, 2);
    world.store().column<Ember>().remove(coal);
    steps(world, 2);
    EXPECT_EQ(statusOf(world, "Heat <- Ember").activity, Activity::absent);
    EXPECT_EQ(world.find<StoveLog>()->held, 1);
}

struct Trail {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{"Trail", "trail",
                                       "All calls in the order in which they were drained."};
    static constexpr Coverage coverage = hashed;
    static constexpr std::string_view standing = "kept over all parts";
    std::vector<double> energies;
};
struct Recorder final : Resolver<Recorder, HeatRole, Reads<>, Writes<Heat>, Provides<Trail>> {
    static constexpr ComponentText text{
        .name = "Recorder", .effect = "heat", .level = "", .work = "Records."};
    using Activation = NeedsAny<Heat>;
    void advance(Access& access) {
        auto& energies = access.provide<Trail>().energies;
        energies.clear();
        access.forCalls<Strike>([&](Strike const& call, CallOrigin) { energies.push_back(call.energy); });
    }
};
// Calls before, in and after its chunks, whose number increases.
struct ManyStrikes final : Interaction<ManyStrikes, HeatRole, Reads<Heat>> {
    static constexpr ComponentText text{
        .name = "Strike <- Heat", .effect = "heat", .level = "", .work = "Strikes."};
    using Activation = NeedsAny<Heat>;
    void apply(Access& access) {
        access.call(Strike{ObjectId{}, -1});
        auto const& heat = access.read<Heat>();
        access.forChunks(heat.size(), [&](Caller& caller, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                caller.call(Strike{ObjectId{}, heat.values()[i].value});
            }
        });
        access.call(Strike{ObjectId{}, -2});
    }
};

TEST(InteractionCallsParallel, AreDrainedInTheSameOrderForAnyNumberOfThreads) {
    constexpr int count = 5000;
    std::vector<double> first;
    for (bool const trace : {false, true}) {
        for (int const threads : {1, 2, 3, 8}) {
            Registry registry;
            registry.component<Recorder>();
            registry.component<ManyStrikes>();
            World world(registry, {.threads = threads, .detail = {}, .periods = {}, .trace = trace});
            for (int i = 0; i < count; ++i) {
                thing(world, "thing " + std::to_string(i), i);
            }
            world.start();
            steps(world, 2);
            std::vector<double> const& energies = world.find<Trail>()->energies;
            ASSERT_EQ(energies.size(), static_cast<std::size_t>(count + 2));
            if (first.empty()) {
                first = energies;
                // In order of chunks: calls from outside of chunks belong to the first one.
                EXPECT_EQ(energies[0], -1);
                EXPECT_EQ(energies[1], 0);
                EXPECT_EQ(energies[chunkRows], chunkRows - 1);
                EXPECT_EQ(energies[chunkRows + 1], -2);
                EXPECT_EQ(energies.back(), count - 1);
            }
            EXPECT_EQ(energies, first) << threads;
        }
    }
}

struct FirstTimes final : Interaction<FirstTimes, HeatRole, Reads<Heat>> {
    static constexpr ComponentText text{
        .name = "First <- Heat", .effect = "heat", .level = "", .work = "Asks."};
    using Activation = NeedsAll<Fuel>;
    void apply(Access& access) {
        if (access.firstTime()) {
            access.call(Strike{ObjectId{}, 100});
        }
    }
};

TEST(Interaction, RecognisesItsFirstTurnAfterEveryConstruction) {
    Registry registry;
    registry.component<Furnace>();
    registry.component<FirstTimes>();
    World world(registry);
    ObjectId const coal = thing(world, "coal", 0, 1);
    world.start();
    steps(world, 5);
    EXPECT_EQ(world.find<StoveLog>()->onceEver, 1);
    world.store().column<Fuel>().remove(coal); // the interaction is removed
    steps(world, 2);
    EXPECT_EQ(statusOf(world, "First <- Heat").activity, Activity::absent);
    world.store().column<Fuel>().set(coal, {1}); // it is constructed again
    steps(world, 5);
    EXPECT_EQ(world.find<StoveLog>()->onceEver, 2);
}

// Strikes while it has strikes left, whatever changes.
struct RestlessStrikes final : Interaction<RestlessStrikes, HeatRole, Reads<Fuel>> {
    static constexpr ComponentText text{
        .name = "Strike <- Clock", .effect = "heat", .level = "", .work = "Strikes."};
    using Activation = NeedsAll<Fuel>;
    static constexpr Coverage memory = leftOut("a test's counter");
    [[nodiscard]] bool restless() const { return left_ > 0; }
    void apply(Access& access) {
        --left_;
        forEach([&](ObjectId id, Fuel const&) { access.call(Strike{id, 1}); }, access.read<Fuel>());
    }

private:
    int left_ = 3;
};

TEST(InteractionTurns, AreInEveryFrameWhileItIsRestless) {
    Registry registry;
    registry.component<Furnace>();
    registry.component<RestlessStrikes>();
    World world(registry);
    ObjectId const coal = thing(world, "coal", 0, 1);
    world.start();
    steps(world, 6);
    EXPECT_EQ(statusOf(world, "Strike <- Clock").updates, 3U);
    EXPECT_EQ(statusOf(world, "Strike <- Clock").activity, Activity::asleep);
    EXPECT_EQ(world.find<Heat>(coal)->value, 3);
    world.store().column<Fuel>().touch();
    steps(world, 3);
    EXPECT_EQ(statusOf(world, "Strike <- Clock").updates, 4U) << "it wakes by what it reads as well";
}

} // namespace
} // namespace interaction_test
} // namespace trembler
