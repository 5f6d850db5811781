// Detail levels and periods by name: swaps in a running world, and error messages that list the valid names.
#include "tests/runtime/world/heat.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace trembler {
namespace world_options_test {
namespace {

using namespace heat;

std::string messageOf(std::function<void()> const& f) {
    try {
        f();
    } catch (std::invalid_argument const& error) {
        return error.what();
    }
    return "(nothing was thrown)";
}
void expectMentions(std::string const& message, std::initializer_list<char const*> words) {
    for (char const* word : words) {
        EXPECT_NE(message.find(word), std::string::npos) << "'" << word << "' in: " << message;
    }
}

Registry& levels() {
    static Registry registry = [] {
        Registry made;
        made.component<Stove>();
        made.component<Furnace>();
        made.component<ExactGlow>();
        made.component<RoughGlow>();
        made.component<HeatFromFuel>();
        return made;
    }();
    return registry;
}

ObjectId hotThing(World& world, std::string const& name, double heat) {
    ObjectId const id = world.store().create(name);
    world.store().column<Heat>().set(id, {heat});
    return id;
}

TEST(WorldOptions, TheCheapestLevelThatSuitsTheSceneIsPicked) {
    World world(levels());
    hotThing(world, "a", 1);
    hotThing(world, "b", 1);
    EXPECT_EQ(statusOf(world, "Rough Glow").choice.reason, ChoiceReason::undecided);
    world.start();
    world.step();
    EXPECT_EQ(statusOf(world, "Rough Glow").choice.reason, ChoiceReason::leastRank);
    EXPECT_EQ(statusOf(world, "Exact Glow").choice.reason, ChoiceReason::alternativeChosen);
    EXPECT_EQ(world.status().at(statusOf(world, "Exact Glow").choice.alternative.value()).info->text.name,
              "Rough Glow");
    EXPECT_EQ(statusOf(world, "Rough Glow").activity, Activity::active);
    EXPECT_EQ(statusOf(world, "Exact Glow").activity, Activity::absent);
    EXPECT_EQ(statusOf(world, "Stove").updates, 1U);
    EXPECT_EQ(statusOf(world, "Furnace").updates, 0U);
    hotThing(world, "c", 1); // one too many for the rough one
    world.step();
    EXPECT_EQ(statusOf(world, "Rough Glow").activity, Activity::absent);
    EXPECT_EQ(statusOf(world, "Exact Glow").activity, Activity::active);
    EXPECT_EQ(world.find<Glow>()->updatesByRough, 1) << "the slot's value is kept";
    EXPECT_EQ(world.find<Glow>()->total, 3);
}

TEST(WorldOptions, ASwapKeepsTheSlotAndTakesEffectInTheNextFrame) {
    World world(levels());
    hotThing(world, "a", 5);
    world.start();
    for (int i = 0; i < 4; ++i) {
        world.step();
    }
    EXPECT_EQ(world.find<Glow>()->updatesByRough, 1);
    world.setDetail("glow", "exact");
    EXPECT_EQ(world.find<Glow>()->updatesByRough, 1);
    EXPECT_EQ(world.find<Glow>()->total, 5);
    EXPECT_EQ(statusOf(world, "Rough Glow").activity, Activity::absent);
    world.step();
    EXPECT_EQ(world.find<Glow>()->updatesByExact, 1)
        << "a new component has its first turn although nothing has changed";
    world.setDetail("glow", "");
    world.step();
    EXPECT_EQ(world.find<Glow>()->updatesByRough, 2) << "the scene determines the choice again";
}

TEST(WorldOptions, ASwappedResolverCarriesOnWithHeldCallsAndItsOwnSlot) {
    World world(levels());
    ObjectId const coal = hotThing(world, "coal", 0);
    world.store().column<Fuel>().set(coal, {60});
    world.start();
    world.step();
    world.step(); // the stove carries out the held call once and then sleeps, as nothing changes
    world.step();
    EXPECT_DOUBLE_EQ(world.find<Heat>(coal)->value, 1);
    int const advances = world.find<StoveLog>()->advances;
    world.setDetail("heat", "furnace");
    for (int i = 0; i < 10; ++i) {
        world.step();
    }
    EXPECT_EQ(world.find<StoveLog>()->advances, advances + 10);
    EXPECT_EQ(world.find<StoveLog>()->held, 1);
    EXPECT_NEAR(world.find<Heat>(coal)->value, 11, 1e-12);
    EXPECT_EQ(statusOf(world, "Heat <- Fuel").updates, 1U)
        << "the interaction did not have to repeat the call";
}

TEST(WorldOptions, LevelsRequestedAtTheStartAreUsed) {
    World world(levels(), {.threads = 1, .detail = {{"glow", "exact"}}, .periods = {}});
    hotThing(world, "a", 1);
    world.start();
    world.step();
    EXPECT_EQ(statusOf(world, "Exact Glow").updates, 1U);
    EXPECT_EQ(statusOf(world, "Exact Glow").choice.reason, ChoiceReason::levelAskedFor);
    EXPECT_EQ(world.options().detail.at("glow"), "exact");
}

TEST(WorldOptions, UnknownLevelsAndEffectsAreRefusedWithTheKnownOnes) {
    World world(levels());
    expectMentions(messageOf([&] { world.setDetail("glow", "fine"); }), {"glow", "fine", "exact", "rough"});
    expectMentions(messageOf([&] { world.setDetail("glwo", "exact"); }), {"glwo", "glow", "heat"});
    expectMentions(messageOf([] {
                       World w(levels(), {.threads = 1, .detail = {{"glow", "x"}}, .periods = {}});
                   }),
                   {"exact", "rough"});
    EXPECT_TRUE(world.options().detail.empty()) << "a refused level changes nothing";
}

TEST(WorldOptions, UnknownComponentsAndPeriodsAreRefusedWithTheKnownOnes) {
    World world(levels());
    expectMentions(messageOf([&] { world.setPeriod("Stov", 2); }),
                   {"Stov", "Stove Resolver", "Exact Glow DPS", "(Heat <- Fuel) Interaction"});
    expectMentions(messageOf([&] { world.setPeriod("Stove", 0); }), {"Stove", "0", "1 to 3600"});
    expectMentions(messageOf([&] { world.setPeriod("Stove", 3601); }), {"3601"});
    world.setPeriod("Stove", 7);
    EXPECT_EQ(statusOf(world, "Stove").period, 7);
    world.setPeriod("(Heat <- Fuel) Interaction", 2);
    EXPECT_EQ(statusOf(world, "Heat <- Fuel").period, 2);
}

TEST(WorldOptions, AnInteractionWithoutAPeriodIsLeftOutUntilItHasOneAgain) {
    World world(levels(), {.threads = 1, .detail = {{"heat", "furnace"}}, .periods = {}});
    ObjectId const coal = hotThing(world, "coal", 1);
    world.store().column<Fuel>().set(coal, {60});
    world.start();
    world.step();
    world.step();
    EXPECT_EQ(world.find<StoveLog>()->held, 1);
    world.setPeriod("Heat <- Fuel", 0);
    EXPECT_EQ(statusOf(world, "Heat <- Fuel").activity, Activity::absent);
    world.step();
    double const heat = world.find<Heat>(coal)->value;
    EXPECT_EQ(world.find<StoveLog>()->held, 0) << "the call that it held is withdrawn";
    world.step();
    EXPECT_EQ(world.find<Heat>(coal)->value, heat);
    world.setPeriod("Heat <- Fuel", 1);
    world.step(); // is applied
    world.step(); // and takes effect
    EXPECT_EQ(world.find<StoveLog>()->held, 1);
    EXPECT_GT(world.find<Heat>(coal)->value, heat);
}

struct StoveGlow final : Dps<StoveGlow, Reads<Fuel>, Derives<>> {
    static constexpr ComponentText text{.name = "Stove", .effect = "glow", .level = "", .work = "Nothing."};
    using Activation = NeedsAll<Fuel>;
    void update(Access&) {}
};

TEST(WorldOptions, APeriodForAnAmbiguousNameIsRefused) {
    Registry registry;
    registry.component<Stove>();
    registry.component<StoveGlow>();
    World world(registry);
    expectMentions(messageOf([&] { world.setPeriod("Stove", 2); }), {"Stove Resolver", "Stove DPS"});
    world.setPeriod("Stove DPS", 2);
    std::vector<ComponentStatus> const status = world.status();
    EXPECT_EQ(status[0].period, 1);
    EXPECT_EQ(status[1].period, 2);
}

struct ReasonedGlow final : Dps<ReasonedGlow, Reads<Heat>, Derives<Glow>> {
    static constexpr ComponentText text{
        .name = "Reasoned Glow", .effect = "glow", .level = "reasoned", .work = "Nothing.", .rank = 0};
    using Activation = NeedsAny<Heat>;
    static std::string why(Store const& store) {
        return std::to_string(store.findColumn<Heat>()->size()) + " hot objects";
    }
    void update(Access&) {}
};

TEST(WorldOptions, TheReasonOfTheChosenLevelIsStated) {
    Registry registry;
    registry.component<ReasonedGlow>();
    registry.component<ExactGlow>();
    World world(registry);
    hotThing(world, "a", 1);
    hotThing(world, "b", 1);
    EXPECT_EQ(world.why("glow"), "") << "nothing is selected before the start";
    world.start();
    EXPECT_EQ(world.why("glow"), "2 hot objects");
    EXPECT_EQ(world.why("heat"), "");
    world.setDetail("glow", "exact");
    EXPECT_EQ(world.why("glow"), "") << "the chosen level states no reason";
}

// Alternatives of which only one has providers for its reads.
struct NeedsGlowLog {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{"Nobody's", "nobodys", "What no resolver provides."};
    static constexpr Coverage coverage = hashed;
};
struct CheapButBlind final : Dps<CheapButBlind, Reads<Heat, NeedsGlowLog>, Derives<Glow>> {
    static constexpr ComponentText text{
        .name = "Blind Glow", .effect = "glow", .level = "blind", .work = "Guesses.", .rank = -1};
    using Activation = NeedsAny<Heat>;
    void update(Access& access) { access.derive<Glow>().total = -1; }
};

TEST(WorldOptions, AnAlternativeWithoutProvidersOfItsReadsIsNotPicked) {
    Registry registry;
    registry.component<CheapButBlind>();
    registry.component<ExactGlow>();
    World world(registry);
    hotThing(world, "a", 2);
    world.start();
    world.step();
    ASSERT_NE(world.find<Glow>(), nullptr);
    EXPECT_EQ(world.find<Glow>()->total, 2);
}

} // namespace
} // namespace world_options_test
} // namespace trembler
