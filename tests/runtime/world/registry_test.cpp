// Rules that cannot be checked at compile time: violations are rejected at start, by name.
#include "runtime/placement.hpp"
#include "runtime/population/population_resolver.hpp"
#include "tests/runtime/world/heat.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace registry_test {
namespace {

using namespace heat;

std::string refusalOf(Registry const& registry) {
    try {
        registry.check();
    } catch (RuleBroken const& error) {
        return error.what();
    }
    return "(accepted)";
}
void expectRefusal(Registry const& registry, std::initializer_list<char const*> words) {
    std::string const why = refusalOf(registry);
    EXPECT_NE(why, "(accepted)");
    for (char const* word : words) {
        EXPECT_NE(why.find(word), std::string::npos) << "'" << word << "' in: " << why;
    }
    EXPECT_THROW(World{registry}, RuleBroken) << "no world can be made with it";
}

// A role and a resolver for each number, so that tests can have as many as they like.
template <int n>
struct RoleOf {
    static constexpr std::string_view name = "Role";
    using Calls = CallList<>;
};
template <int n>
inline constexpr std::string_view letter = n == 0   ? "A"
                                           : n == 1 ? "B"
                                                    : "C";
template <int n, class Writing, class Providing = Provides<>, int role = n>
struct ResolverOf final
    : Resolver<ResolverOf<n, Writing, Providing, role>, RoleOf<role>, Reads<>, Writing, Providing> {
    static constexpr ComponentText text{
        .name = letter<n>, .effect = "test", .level = letter<n>, .work = "Nothing."};
    using Activation = NeedsAll<>;
    using Access = typename Resolver<ResolverOf, RoleOf<role>, Reads<>, Writing, Providing>::Access;
    void advance(Access&) {}
};
using WritesHeatA = ResolverOf<0, Writes<Heat>>;
using WritesHeatB = ResolverOf<1, Writes<Fuel, Heat>>;
using WritesFuelC = ResolverOf<2, Writes<Fuel>>;

TEST(RegistryRules, TwoWritersOfOnePropertyAreRefusedByName) {
    Registry registry;
    registry.component<WritesHeatA>();
    registry.component<WritesHeatB>();
    expectRefusal(registry, {"A Resolver", "B Resolver", "both write Heat"});
}

TEST(RegistryRules, AreCheckedAgainAfterAnotherRegistration) {
    Registry registry;
    registry.component<WritesHeatA>();
    EXPECT_EQ(refusalOf(registry), "(accepted)");
    EXPECT_EQ(refusalOf(registry), "(accepted)") << "nothing was added";
    registry.component<WritesHeatB>();
    expectRefusal(registry, {"A Resolver", "B Resolver", "both write Heat"});
    expectRefusal(registry, {"A Resolver", "B Resolver", "both write Heat"}); // also the next time
}

TEST(RegistryRules, TwoEffectsWithTheSameKindOfConnectionsAreRefusedByName) {
    auto const refuse = [](Store const&, ObjectId, ObjectId) { return std::optional<std::string>(); };
    auto const lay = [](Store&, ObjectId, ObjectId) {};
    Registry registry;
    registry.connector({"wire", "electricity", "a wire", refuse, lay});
    registry.connector({"pipe", "plumbing", "a pipe", refuse, lay});
    EXPECT_EQ(refusalOf(registry), "(accepted)");
    EXPECT_EQ(registry.connectionKinds(), (std::vector<std::string>{"pipe", "wire"}));
    registry.connector({"wire", "fencing", "a fence", refuse, lay});
    expectRefusal(registry, {"'electricity'", "'fencing'", "'wire'"});
}

TEST(RegistryRules, AlternativesOfOneRoleMayWriteTheSame) {
    Registry registry;
    registry.component<Stove>();
    registry.component<Furnace>();
    EXPECT_EQ(refusalOf(registry), "(accepted)");
}

TEST(RegistryRules, ResolversOfOneRoleMustOfferTheSame) {
    Registry registry;
    registry.component<ResolverOf<0, Writes<>, Provides<StoveLog>, 7>>();
    registry.component<ResolverOf<1, Writes<>, Provides<>, 7>>();
    expectRefusal(registry, {"A Resolver", "B Resolver", "do not offer the same"});
}

TEST(RegistryRules, TwoResolversOfferingOnePropertyAreRefused) {
    Registry registry;
    registry.component<ResolverOf<0, Writes<>, Provides<StoveLog>>>();
    registry.component<ResolverOf<1, Writes<>, Provides<StoveLog>>>();
    expectRefusal(registry, {"A Resolver", "B Resolver", "Stove log"});
}

struct Aura {
    static constexpr PropertyKind kind = PropertyKind::derived;
    static constexpr PropertyText text{"Aura", "aura", "What glows around things."};
};
struct GlowAndAura final : Dps<GlowAndAura, Reads<Heat>, Derives<Glow, Aura>> {
    static constexpr ComponentText text{
        .name = "Glow and Aura", .effect = "glow", .level = "both", .work = "Both."};
    using Activation = NeedsAny<Heat>;
    void update(Access&) {}
};

TEST(RegistryRules, HalfOverlappingAlternativesAreRefused) {
    Registry registry;
    registry.component<ExactGlow>();
    registry.component<GlowAndAura>();
    expectRefusal(registry, {"Exact Glow DPS", "Glow and Aura DPS", "Glow", "not the same set"});
}

struct SameTitle final : Dps<SameTitle, Reads<Heat>, Derives<Glow>> {
    static constexpr ComponentText text{
        .name = "Exact Glow", .effect = "glow", .level = "again", .work = "Again."};
    using Activation = NeedsAny<Heat>;
    void update(Access&) {}
};

TEST(RegistryRules, TwoComponentsOfOneTitleAreRefused) {
    Registry registry;
    registry.component<ExactGlow>();
    registry.component<SameTitle>();
    expectRefusal(registry, {"two components are called Exact Glow DPS"});
    Registry twice;
    twice.component<Stove>();
    twice.component<Stove>();
    expectRefusal(twice, {"two components are called Stove Resolver"});
}

struct OtherHeat {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Other heat", "heat", "Another property with the key of Heat."};
};

TEST(RegistryRules, TwoPropertiesOfOneKeyAreRefused) {
    Registry registry;
    registry.component<ExactGlow>();
    registry.property<OtherHeat>();
    expectRefusal(registry, {"Heat", "Other heat", "'heat'"});
}

struct SecondPopulation final : Resolver<SecondPopulation, RoleOf<9>, Reads<>, Writes<>> {
    static constexpr ComponentText text{
        .name = "Second Population", .effect = "test", .level = "", .work = "All."};
    static constexpr bool writesEverything = true;
    using Activation = NeedsAll<>;
    void advance(Access&) {}
};

TEST(RegistryRules, OnlyOneResolverWritesEverything) {
    Registry registry;
    registerRuntime(registry);
    registry.component<SecondPopulation>();
    expectRefusal(registry, {"Population Resolver", "Second Population Resolver", "both write everything"});
}

TEST(Registry, FindsEveryObjectPropertyOfItsComponentsByKey) {
    Registry registry;
    registry.component<Stove>();
    registry.component<HeatFromFuel>();
    registry.property<Position>();
    std::vector<PropertyInfo const*> const known = registry.objectProperties();
    EXPECT_EQ(known, (std::vector<PropertyInfo const*>{&propertyInfo<Position>(), &propertyInfo<Fuel>(),
                                                       &propertyInfo<Heat>()})); // at, fuel, heat
    EXPECT_EQ(registry.objectProperty("fuel"), &propertyInfo<Fuel>());
    EXPECT_EQ(registry.objectProperty("stove_log"), nullptr) << "a resolver property belongs to no object";
    EXPECT_EQ(registry.objectProperty("hea"), nullptr);
}

// One type, registered for several powers.
struct Power {
    ComponentText text;
    double joules = 0; // added in each turn
    bool (*suits)(Store const&) = nullptr;
    std::string_view missing{};
};
class Hob final : public Resolver<Hob, RoleOf<4>, Reads<>, Writes<Heat>> {
public:
    using Activation = NeedsAll<Heat>;
    static constexpr Coverage memory = leftOut("a constant of its registration");
    Hob(ComponentInfo const& info, Power const& power) : Resolver(info), joules_(power.joules) {}
    [[nodiscard]] bool restless() const { return true; }
    void advance(Access& access) {
        for (Heat& heat : access.write<Heat>().values()) {
            heat.value += joules_;
        }
    }

private:
    double joules_;
};
constexpr Power low{.text{.name = "Low", .effect = "hob", .level = "low", .work = "Heats.", .rank = 1},
                    .joules = 1,
                    .suits = [](Store const& store) { return store.findColumn<Fuel>() != nullptr; }};
constexpr Power high{.text{.name = "High", .effect = "hob", .level = "high", .work = "Heats.", .rank = 2},
                     .joules = 100};
constexpr Power absent{.text{.name = "Absent", .effect = "hob", .level = "absent", .work = "Nothing."},
                       .missing = "there is no gas"};

TEST(Registry, RegistersATypeSeveralTimesWithDifferentValues) {
    Registry registry;
    for (Power const* power : {&low, &high, &absent}) {
        registry.component<Hob>(*power);
    }
    ASSERT_EQ(registry.components().size(), 3U);
    EXPECT_EQ(registry.components()[0].suits, low.suits);
    EXPECT_EQ(registry.components()[1].suits, nullptr);
    EXPECT_EQ(registry.components()[2].missing, "there is no gas");
    EXPECT_EQ(title(*registry.components()[1].info), "High Resolver");
    EXPECT_EQ(registry.components()[1].info->writes, registry.components()[0].info->writes);
    EXPECT_EQ(refusalOf(registry), "(accepted)") << "resolvers of one role swap";

    World world(registry);
    ObjectId const pan = world.store().create("pan");
    world.store().column<Heat>().set(pan, {0});
    world.start();
    world.step();
    EXPECT_EQ(world.find<Heat>(pan)->value, 100) << "the low one does not suit";
    world.setDetail("hob", "low");
    world.step();
    EXPECT_EQ(world.find<Heat>(pan)->value, 101);
    EXPECT_THROW(world.setDetail("hob", "absent"), std::invalid_argument);
}

TEST(Registry, TakesPeriodsAndSuitabilityFromTheComponent) {
    Registry registry;
    registry.component<RoughGlow>();
    registry.component<ExactGlow>();
    EXPECT_NE(registry.components()[0].suits, nullptr);
    EXPECT_EQ(registry.components()[1].suits, nullptr);
    EXPECT_EQ(registry.components()[1].period, 1);
}

} // namespace
} // namespace registry_test
} // namespace trembler
