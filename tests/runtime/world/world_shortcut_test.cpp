// Interactions inside derived property sets (5.7.3): the same results, and only where the condition holds.
#include "runtime/notation/notation.hpp"
#include "tests/runtime/world/heat.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace trembler {
namespace world_shortcut_test {
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

template <bool inside>
struct GlowKit {
    Registry registry;
    GlowKit() {
        registry.component<Furnace>();
        registry.component<ExactGlow>();
        registry.component<RoughGlow>();
        registry.component<HeatFromGlow>();
        if constexpr (inside) {
            registry.shortcut<HeatFromGlow, ExactGlow>();
            registry.shortcut<HeatFromGlow, RoughGlow>();
        }
    }
};

TEST(WorldShortcut, ChangesNoBit) {
    GlowKit<false> plain;
    GlowKit<true> inside;
    for (int const glowPeriod : {1, 3}) {
        for (int const strikePeriod : {1, 2}) {
            WorldOptions const options{.threads = 1,
                                       .detail = {},
                                       .periods = {{"Exact Glow", glowPeriod},
                                                   {"Rough Glow", glowPeriod},
                                                   {"Heat <- Glow", strikePeriod}}};
            World a(plain.registry, options);
            World b(inside.registry, options);
            for (World* world : {&a, &b}) {
                world->store().column<Heat>().set(world->store().create("coal"), {1});
                world->start();
            }
            for (int frame = 1; frame <= 20; ++frame) {
                if (frame == 10) {
                    a.setDetail("glow", "exact");
                    b.setDetail("glow", "exact");
                }
                a.step();
                b.step();
                ASSERT_EQ(a.stateHash(), b.stateHash()) << frame;
                ASSERT_EQ(statusOf(a, "Heat <- Glow").updates, statusOf(b, "Heat <- Glow").updates) << frame;
                ASSERT_EQ(statusOf(a, "Heat <- Glow").activity, statusOf(b, "Heat <- Glow").activity)
                    << frame;
            }
        }
    }
}

TEST(WorldShortcut, SleepsWithItsDerivedPropertySet) {
    Registry registry;
    registry.component<Stove>();
    registry.component<ExactGlow>();
    registry.component<HeatFromFuel>();
    registry.shortcut<HeatFromFuel, ExactGlow>();
    World world(registry);
    ObjectId const coal = world.store().create("coal");
    world.store().column<Heat>().set(coal, {1});
    world.store().column<Fuel>().set(coal, {1});
    world.start();
    world.step();
    EXPECT_EQ(statusOf(world, "Heat <- Fuel").activity, Activity::active);
    for (int i = 0; i < 5; ++i) {
        world.step();
    }
    EXPECT_EQ(statusOf(world, "Heat <- Fuel").activity, Activity::asleep);
    EXPECT_EQ(statusOf(world, "Heat <- Fuel").updates, 1U);
}

struct Shade {
    static constexpr PropertyKind kind = PropertyKind::derived;
    static constexpr PropertyText text{"Shade", "shade", "Where it is dark."};
};
struct Shading final : Dps<Shading, Reads<Heat>, Derives<Shade>> {
    static constexpr ComponentText text{.name = "Shading", .effect = "shade", .level = "", .work = "Shades."};
    using Activation = NeedsAll<Heat>;
    void update(Access&) {}
};
struct HeatFromBoth final : Interaction<HeatFromBoth, HeatRole, Reads<Glow, Shade>> {
    static constexpr ComponentText text{
        .name = "Heat <- Both", .effect = "heat", .level = "", .work = "Strikes."};
    using Activation = NeedsAll<>;
    void apply(Access&) {}
};

TEST(WorldShortcut, IsRefusedForReadsOfAnotherDerivedPropertySet) {
    Registry registry;
    registry.component<Stove>();
    registry.component<ExactGlow>();
    registry.component<Shading>();
    registry.component<HeatFromBoth>();
    EXPECT_EQ(refusalOf(registry), "(accepted)");
    registry.shortcut<HeatFromBoth, ExactGlow>();
    std::string const why = refusalOf(registry);
    for (char const* word : {"(Heat <- Both) Interaction", "Exact Glow DPS", "Shade", "5.7.3"}) {
        EXPECT_NE(why.find(word), std::string::npos) << word << " in: " << why;
    }
    EXPECT_THROW(World{registry}, RuleBroken);
}

TEST(WorldShortcut, IsRefusedInTwoSetsThatMayCoexist) {
    Registry registry;
    registry.component<Stove>();
    registry.component<ExactGlow>();
    registry.component<RoughGlow>();
    registry.component<Shading>();
    registry.component<HeatFromFuel>();
    registry.shortcut<HeatFromFuel, ExactGlow>();
    registry.shortcut<HeatFromFuel, RoughGlow>();
    EXPECT_EQ(refusalOf(registry), "(accepted)");
    registry.shortcut<HeatFromFuel, Shading>();
    EXPECT_NE(refusalOf(registry).find("Shading DPS"), std::string::npos) << refusalOf(registry);
}

TEST(WorldShortcut, IsRefusedForUnregisteredComponentsAndOtherKinds) {
    Registry unknown;
    unknown.component<ExactGlow>();
    unknown.shortcut<HeatFromGlow, ExactGlow>();
    EXPECT_NE(refusalOf(unknown).find("not registered"), std::string::npos);
    Registry kinds;
    kinds.component<Stove>();
    kinds.component<ExactGlow>();
    kinds.shortcut<ExactGlow, Stove>();
    EXPECT_NE(refusalOf(kinds).find("a shortcut (5.7.3) puts an interaction into"), std::string::npos);
}

TEST(WorldShortcut, IsShownInTheNotation) {
    GlowKit<true> kit;
    Registration const& interaction = kit.registry.components()[3];
    std::string const box = notationBox(kit.registry, interaction);
    EXPECT_NE(box.find("directly after the Exact Glow DPS"), std::string::npos) << box;
    EXPECT_NE(box.find("Rough Glow DPS"), std::string::npos) << box;
    GlowKit<false> plain;
    EXPECT_EQ(notationBox(plain.registry, plain.registry.components()[3]).find("directly after"),
              std::string::npos);
}

} // namespace
} // namespace world_shortcut_test
} // namespace trembler
