// The trace of a world: held calls are recorded once, causes are linked, and it is the same for any number of
// threads.
#include "runtime/population/population_resolver.hpp"
#include "tests/runtime/world/heat.hpp"
#include "tests/support/sanitizer.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace trembler {
namespace {

using namespace heat;

std::vector<Event> eventsNamed(World const& world, std::string_view name) {
    std::vector<Event> found;
    for (Event const& event : world.tracer()->events()) {
        if (event.event == name) {
            found.push_back(event);
        }
    }
    return found;
}

// "this will be done for every frame from now on and will not be mentioned again" (6.8.3)
TEST(WorldTrace, RecordsAHeldCallOncePerPeriodOfHolding) {
    Registry registry;
    registry.component<Furnace>();
    registry.component<HeatFromFuel>();
    World world(registry, {.threads = 1, .detail = {}, .periods = {}, .trace = true});
    ObjectId const coal = world.store().create("coal");
    world.store().column<Heat>().set(coal, {0});
    world.store().column<Fuel>().set(coal, {1});
    world.start();
    for (int i = 0; i < 5; ++i) {
        world.store().column<Fuel>().set(coal, {1.0 + i}); // applied again in every frame
        world.step();
    }
    ASSERT_EQ(eventsNamed(world, "addHeat").size(), 1U);
    EXPECT_EQ(eventsNamed(world, "addHeat")[0].frame, 1U);
    EXPECT_EQ(eventsNamed(world, "addHeat")[0].component, "Heat <- Fuel");
    world.store().column<Fuel>().remove(coal);
    world.step();
    world.store().column<Fuel>().set(coal, {1}); // held again after a pause: recorded again
    world.step();
    EXPECT_EQ(eventsNamed(world, "addHeat").size(), 2U);
}

TEST(WorldTrace, LeadsFromAnEffectBackToItsCause) {
    Registry registry;
    registry.component<Furnace>();
    registry.component<ExactGlow>();
    registry.component<HeatFromGlow>();
    World world(registry, {.threads = 1, .detail = {}, .periods = {}, .trace = true});
    world.store().column<Heat>().set(world.store().create("coal"), {0});
    world.start();
    world.step();
    world.step();
    std::vector<Event> const struck = eventsNamed(world, "struck");
    ASSERT_EQ(struck.size(), 1U);
    EXPECT_EQ(struck[0].frame, 2U);
    std::vector<EventId> const chain = world.tracer()->chain(struck[0].id);
    ASSERT_EQ(chain.size(), 2U);
    EXPECT_EQ(world.tracer()->find(chain[0])->event, "strike");
    EXPECT_EQ(world.tracer()->find(chain[0])->frame, 1U);
    EXPECT_EQ(world.tracer()->find(chain[0])->phase, Phase::interaction);
}

// Removes the last object that activates it, and thereby itself.
struct BurnsOut final : Resolver<BurnsOut, HeatRole, Reads<>, Writes<Heat>> {
    static constexpr ComponentText text{
        .name = "Burns out", .effect = "heat", .level = "", .work = "Burns everything at once."};
    using Activation = NeedsAny<Heat>;
    void advance(Access& access) {
        std::vector<ObjectId> const all(access.read<Heat>().owners().begin(),
                                        access.read<Heat>().owners().end());
        for (ObjectId const id : all) {
            access.event("burnt out", {id}, {});
        }
        access.write<Heat>().removeAll(all);
    }
};

TEST(WorldTrace, KeepsTheEventsOfAComponentsLastFrame) {
    Registry registry;
    registry.component<BurnsOut>();
    World world(registry, {.threads = 1, .detail = {}, .periods = {}, .trace = true});
    world.store().column<Heat>().set(world.store().create("coal"), {1});
    world.start();
    world.step();
    EXPECT_EQ(statusOf(world, "Burns out").activity, Activity::absent);
    EXPECT_EQ(eventsNamed(world, "burnt out").size(), 1U);
}

TEST(WorldTrace, NeedsNoMemoryWithoutTracing) {
    Registry registry;
    registry.component<Furnace>();
    World world(registry);
    world.store().column<Heat>().set(world.store().create("coal"), {0});
    world.start();
    world.step();
    EXPECT_EQ(world.tracer(), nullptr);
    ObjectId const none{};
    EXPECT_FALSE(static_cast<bool>(world.note("goal", "met", std::span(&none, 1), {})));
}

// More than 10,000 objects, several interactions in many chunks, some calls once, some held, objects that
// gain and lose properties: neither the trace nor the state may depend on threads.
TEST(WorldTraceParallel, IsTheSameForAnyNumberOfThreads) {
    Registry registry;
    registerRuntime(registry);
    registry.component<Furnace>();
    registry.component<ExactGlow>();
    registry.component<HeatFromFuel>();
    registry.component<HeatFromGlow>();
    std::string account;
    std::vector<std::uint64_t> hashes;
    // For a sanitizer one number of threads is sufficient, and the thread sanitizer needs no comparison.
    for (int const threads : test::underThreadSanitizer ? std::vector{8}
                             : test::underSanitizer     ? std::vector{1, 8}
                                                        : std::vector{1, 2, 3, 8, 32}) {
        World world(registry,
                    {.threads = threads, .detail = {}, .periods = {{"Exact Glow", 2}}, .trace = true});
        constexpr std::uint32_t count = 5000; // five chunks
        std::vector<ObjectId> ids;
        for (std::uint32_t i = 0; i < count; ++i) {
            ids.push_back(world.store().create("thing " + std::to_string(i)));
            world.store().column<Heat>().set(ids.back(), {0.1 * i});
            if (i % 3 != 0) {
                world.store().column<Fuel>().set(ids.back(), {1.0 / (i + 1)});
            }
        }
        world.start();
        std::vector<std::uint64_t> mine;
        for (int frame = 1; frame <= 5; ++frame) {
            if (frame == 3) {
                world.store().column<Fuel>().set(ids[3], {5}); // rows shift: other chunks
                world.feed({.kind = PlayerInput::Kind::remove, .object = ids[2500], .other = {}, .at = {}});
            }
            world.step();
            mine.push_back(world.stateHash());
        }
        EXPECT_GT(world.tracer()->events().size(), 13000U);
        if (test::underThreadSanitizer) {
            continue;
        }
        std::ostringstream out;
        world.tracer()->write(out);
        if (account.empty()) {
            account = out.str();
            hashes = mine;
            EXPECT_EQ(eventsNamed(world, "destroyed").size(), 1U);
        }
        EXPECT_TRUE(out.str() == account) << threads << " threads give another trace";
        EXPECT_EQ(mine, hashes) << threads;
    }
}

} // namespace
} // namespace trembler
