// Components whose constructors fail: the world continues with the existing components, and tries again.
#include "tests/runtime/world/heat.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace trembler {
namespace world_components_test {
namespace {

using namespace heat;

/// Constructors of the components below that will still fail.
int failures = 0;

void failIfAsked() {
    if (failures > 0) {
        --failures;
        throw std::runtime_error("no room");
    }
}

struct Spark {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Spark", "spark", "Strikes once."};
};
struct HeatFromSpark final : Interaction<HeatFromSpark, HeatRole, Reads<Spark>> {
    static constexpr ComponentText text{
        .name = "Heat <- Spark", .effect = "heat", .level = "", .work = "Strikes."};
    using Activation = NeedsAll<Spark>;
    HeatFromSpark() { failIfAsked(); }
    void apply(Access& access) {
        forEach([&](ObjectId id, Spark const&) { access.call(Strike{id, 100}); }, access.read<Spark>());
    }
};
struct Warmth {
    static constexpr PropertyKind kind = PropertyKind::derived;
    static constexpr PropertyText text{"Warmth", "warmth", "All heat."};
    double total = 0;
};
struct WarmthOnDemand final : Dps<WarmthOnDemand, Reads<Heat>, Derives<Warmth>> {
    static constexpr ComponentText text{
        .name = "Warmth", .effect = "warmth", .level = "", .work = "Adds up all heat."};
    using Activation = NeedsAny<Heat>;
    static constexpr bool onDemand = true;
    WarmthOnDemand() { failIfAsked(); }
    void update(Access& access) { access.derive<Warmth>().total = totalHeat(access); }
};
struct OtherGlow final : Dps<OtherGlow, Reads<Heat>, Derives<Glow>> {
    static constexpr ComponentText text{
        .name = "Other Glow", .effect = "glow", .level = "other", .work = "Fails.", .rank = 9};
    using Activation = NeedsAny<Heat>;
    OtherGlow() { failIfAsked(); }
    void update(Access& access) { access.derive<Glow>().total = -1; }
};

class WorldComponents : public testing::TestWithParam<bool> {
protected:
    WorldComponents() {
        failures = 0;
        registry_.component<Furnace>();
        registry_.component<ExactGlow>();
        registry_.component<OtherGlow>();
        registry_.component<WarmthOnDemand>();
        registry_.component<HeatFromFuel>(); // before the one that fails: it would be destroyed by then
        registry_.component<HeatFromSpark>();
    }
    ~WorldComponents() override { failures = 0; }

    void begin() {
        world_.emplace(registry_,
                       WorldOptions{.threads = 1, .detail = {}, .periods = {}, .trace = GetParam()});
        coal_ = world_->store().create("coal");
        world_->store().column<Heat>().set(coal_, {0});
        world_->store().column<Fuel>().set(coal_, {60});
        world_->start();
        world_->step();
        world_->step();
        ASSERT_DOUBLE_EQ(heat(), 1);
    }
    [[nodiscard]] double heat() const { return world_->find<Heat>(coal_)->value; }
    [[nodiscard]] bool there(std::string_view name) const {
        return statusOf(*world_, name).activity != Activity::absent;
    }

    Registry registry_;
    std::optional<World> world_;
    ObjectId coal_;
};

// One component must be removed in the selection in which the constructor of another one fails.
TEST_P(WorldComponents, StayUntilTheConstructorsOfOthersSucceed) {
    begin();
    world_->store().column<Fuel>().remove(coal_);
    world_->store().column<Spark>().set(coal_, {});
    failures = 2;
    EXPECT_THROW(world_->step(), std::runtime_error);
    ASSERT_TRUE(there("Heat <- Fuel")) << "or its turns and calls would be those of a destroyed component";
    EXPECT_FALSE(there("Heat <- Spark"));
    EXPECT_THROW(world_->step(), std::runtime_error) << "it tries again";
    ASSERT_TRUE(there("Heat <- Fuel"));
    world_->step();
    EXPECT_FALSE(there("Heat <- Fuel"));
    EXPECT_TRUE(there("Heat <- Spark"));
    double const before = heat();
    world_->step();
    EXPECT_DOUBLE_EQ(heat(), before + 100);
    world_->step();
    EXPECT_DOUBLE_EQ(heat(), before + 100);
}

TEST_P(WorldComponents, ThatASubscriptionNeedsAreConstructedInALaterFrame) {
    begin();
    failures = 1;
    Subscription const reader = world_->want<Warmth>();
    EXPECT_THROW(world_->step(), std::runtime_error);
    EXPECT_FALSE(there("Warmth"));
    world_->step();
    EXPECT_TRUE(there("Warmth"));
    ASSERT_NE(world_->find<Warmth>(), nullptr);
    EXPECT_DOUBLE_EQ(world_->find<Warmth>()->total, heat());
}

TEST_P(WorldComponents, OfAnotherDetailLevelThatFailAreNoLongerRequested) {
    begin();
    failures = 1;
    EXPECT_THROW(world_->setDetail("glow", "other"), std::runtime_error);
    EXPECT_FALSE(world_->options().detail.contains("glow"));
    world_->step();
    EXPECT_TRUE(there("Exact Glow"));
    EXPECT_FALSE(there("Other Glow"));
    EXPECT_DOUBLE_EQ(world_->find<Glow>()->total, heat());
    world_->setDetail("glow", "other");
    world_->step();
    EXPECT_EQ(world_->find<Glow>()->total, -1);
}

TEST_P(WorldComponents, AreConstructedAtTheFirstFrameIfTheStartFailed) {
    world_.emplace(registry_, WorldOptions{.threads = 1, .detail = {}, .periods = {}, .trace = GetParam()});
    coal_ = world_->store().create("coal");
    world_->store().column<Heat>().set(coal_, {0});
    world_->store().column<Spark>().set(coal_, {});
    failures = 1;
    EXPECT_THROW(world_->start(), std::runtime_error);
    world_->step();
    world_->step();
    EXPECT_DOUBLE_EQ(heat(), 100);
}

INSTANTIATE_TEST_SUITE_P(Trace, WorldComponents, testing::Bool(),
                         [](auto const& info) { return info.param ? "kept" : "none"; });

} // namespace
} // namespace world_components_test
} // namespace trembler
