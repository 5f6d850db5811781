// Components without readers are not constructed: components on demand, and readers from outside the world.
#include "tests/runtime/world/heat.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace trembler {
namespace on_demand_test {
namespace {

using namespace heat;

/// A log that a resolver keeps only if it is read.
struct Diary {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{"Diary", "diary", "The number of calls that the scribe received."};
    static constexpr Coverage coverage = hashed;
    static constexpr std::string_view standing = "counts over all parts";
    int entries = 0;
};
struct Note {
    static constexpr CallText text{"note", "(object)", "Notes the object."};
    static constexpr Algebra algebra = Algebra::sumOfAmounts;
    ObjectId object;
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "object", .unit = "", .meaning = "the object", .required = true}, self.object);
    }
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {object}; }
};
struct ScribeRole {
    static constexpr std::string_view name = "Scribe";
    using Calls = CallList<Note>;
};
template <class Self>
struct ScribeBase : Resolver<Self, ScribeRole, Reads<Heat>, Writes<>, Provides<Diary>> {
    static constexpr bool onDemand = true;
    using Activation = NeedsAny<Heat>;
    using Access = typename Resolver<Self, ScribeRole, Reads<Heat>, Writes<>, Provides<Diary>>::Access;
    void advance(Access& access) {
        access.template forCalls<Note>(
            [&](Note const&, CallOrigin) { ++access.template provide<Diary>().entries; });
    }
};
struct Scribe final : ScribeBase<Scribe> {
    static constexpr ComponentText text{
        .name = "Scribe", .effect = "scribe", .level = "plain", .work = "Writes.", .rank = 1};
};
struct Poet final : ScribeBase<Poet> {
    static constexpr ComponentText text{
        .name = "Poet", .effect = "scribe", .level = "fine", .work = "Writes finely.", .rank = 2};
};
struct ScribeFromHeat final : Interaction<ScribeFromHeat, ScribeRole, Reads<Heat>> {
    static constexpr ComponentText text{
        .name = "Scribe <- Heat", .effect = "scribe", .level = "", .work = "Reports all heat."};
    using Activation = NeedsAll<Heat>;
    void apply(Access& access) {
        forEach([&](ObjectId id, Heat const&) { access.call(Note{id}); }, access.read<Heat>());
    }
};
/// Derived on demand, from a property that is kept on demand.
struct Fame {
    static constexpr PropertyKind kind = PropertyKind::derived;
    static constexpr PropertyText text{"Fame", "fame", "Twice the entries."};
    int twice = 0;
};
struct FameByDiary final : Dps<FameByDiary, Reads<Diary>, Derives<Fame>> {
    static constexpr ComponentText text{.name = "Fame", .effect = "fame", .level = "", .work = "Doubles."};
    static constexpr bool onDemand = true;
    using Activation = NeedsAny<Heat>;
    void update(Access& access) { access.derive<Fame>().twice = 2 * access.read<Diary>().entries; }
};
struct HeatFromFame final : Interaction<HeatFromFame, HeatRole, Reads<Fame>> {
    static constexpr ComponentText text{
        .name = "Heat <- Fame", .effect = "heat", .level = "", .work = "Nothing; it reads."};
    using Activation = NeedsAll<Fuel>;
    void apply(Access&) {}
};

struct Scriptorium {
    Registry registry;
    std::unique_ptr<World> world;
    ObjectId stone;

    Scriptorium() {
        registry.component<Stove>();
        registry.component<Scribe>();
        registry.component<Poet>();
        registry.component<FameByDiary>();
        registry.component<ScribeFromHeat>();
        registry.component<HeatFromFame>();
        world = std::make_unique<World>(registry);
        stone = world->store().create("stone");
        world->store().column<Heat>().set(stone, {1});
    }
    [[nodiscard]] Activity of(std::string_view name) const { return statusOf(*world, name).activity; }
};

TEST(OnDemand, IsAbsentWithAllThatDependsOnItWithoutReaders) {
    Scriptorium s;
    s.world->start();
    s.world->step();
    for (char const* name : {"Scribe", "Poet", "Fame", "Scribe <- Heat"}) {
        EXPECT_EQ(s.of(name), Activity::absent) << name;
    }
    EXPECT_EQ(statusOf(*s.world, "Scribe").choice.reason, ChoiceReason::notRead);
    EXPECT_EQ(statusOf(*s.world, "Scribe <- Heat").choice.reason, ChoiceReason::noResolver);
    EXPECT_NE(s.of("Stove"), Activity::absent) << "components that are not on demand are not affected";
}

TEST(OnDemand, IsConstructedForASubscriptionAndRemovedWithIt) {
    Scriptorium s;
    Subscription first = std::as_const(*s.world).want<Diary>(); // a const world is sufficient
    s.world->start();
    s.world->step();
    s.world->step();
    EXPECT_NE(s.of("Scribe"), Activity::absent);
    EXPECT_EQ(s.of("Poet"), Activity::absent) << "only one of the alternatives, as always";
    EXPECT_EQ(s.of("Fame"), Activity::absent) << "its property is not read";
    EXPECT_EQ(s.world->find<Diary>()->entries, 1);
    {
        Subscription const second = s.world->want<Diary>();
        first.end();
        first.end(); // a second end() has no effect
        s.world->step();
        EXPECT_NE(s.of("Scribe"), Activity::absent) << "subscriptions are counted";
        EXPECT_TRUE(second);
        EXPECT_FALSE(first);
    }
    s.world->step();
    EXPECT_EQ(s.of("Scribe"), Activity::absent);
    EXPECT_EQ(s.of("Scribe <- Heat"), Activity::absent);
    EXPECT_EQ(s.world->find<Diary>()->entries, 0) << "no component provides it any more";
    first = s.world->want<Diary>();
    s.world->step();
    EXPECT_NE(s.of("Scribe"), Activity::absent);
}

TEST(OnDemand, ASubscriptionMovesAndMayOutliveItsWorld) {
    Subscription kept;
    {
        Scriptorium s;
        s.world->start();
        Subscription made = s.world->want<Diary>();
        Subscription moved = std::move(made);
        EXPECT_FALSE(made); // NOLINT(bugprone-use-after-move): a moved-from subscription is empty
        EXPECT_TRUE(moved);
        kept = std::move(moved);
        s.world->step();
        EXPECT_NE(s.of("Scribe"), Activity::absent) << "the moved subscription still counts";
        kept = s.world->want<Fame>(); // ends the previous subscription
        s.world->step();
        EXPECT_NE(s.of("Fame"), Activity::absent);
        kept = {};
        s.world->step();
        EXPECT_EQ(s.of("Fame"), Activity::absent);
        kept = s.world->want<Diary>();
        EXPECT_TRUE(kept);
    }
    EXPECT_FALSE(kept) << "its world is destroyed";
    Scriptorium another;
    kept = another.world->want<Diary>();
    EXPECT_TRUE(kept);
}

TEST(OnDemand, AReaderInTheSceneActivatesTheWholeChain) {
    Scriptorium s;
    s.world->store().column<Fuel>().set(s.stone, {0});
    s.world->start();
    for (int i = 0; i < 3; ++i) {
        s.world->step();
    }
    for (char const* name : {"Scribe", "Fame", "Scribe <- Heat", "Heat <- Fame"}) {
        EXPECT_NE(s.of(name), Activity::absent) << name;
    }
    EXPECT_EQ(s.world->find<Fame>()->twice, 2 * s.world->find<Diary>()->entries);
    s.world->store().column<Fuel>().remove(s.stone);
    s.world->step();
    EXPECT_EQ(s.of("Scribe"), Activity::absent) << "the only reader was removed";
}

TEST(OnDemand, OnlyReadersThatObjectsActivateBelongToTheScene) {
    Scriptorium s;
    s.world->start();
    SlotBase const& diary = s.world->store().slot(propertyInfo<Diary>());
    Subscription const fame = s.world->want<Fame>(); // constructs the component that reads the diary
    s.world->step();
    ASSERT_NE(s.of("Fame"), Activity::absent);
    EXPECT_EQ(diary.readers(), 1);
    EXPECT_EQ(diary.ownReaders(), 0);
    Subscription direct = s.world->want<Diary>();
    s.world->step();
    EXPECT_EQ(diary.readers(), 2);
    EXPECT_EQ(diary.ownReaders(), 0);
    s.world->store().column<Fuel>().set(s.stone, {0}); // now an object activates a reader of Fame
    s.world->step();
    EXPECT_EQ(diary.readers(), 2);
    EXPECT_EQ(diary.ownReaders(), 1);
    s.world->store().column<Fuel>().remove(s.stone);
    direct.end();
    s.world->step();
    EXPECT_EQ(diary.readers(), 1);
    EXPECT_EQ(diary.ownReaders(), 0);
}

TEST(OnDemand, SubscribingChangesNoState) {
    Scriptorium wanted;
    Scriptorium unwanted;
    wanted.world->start();
    unwanted.world->start();
    Subscription fame;
    for (int i = 0; i < 10; ++i) {
        if (i % 3 == 1) {
            fame = wanted.world->want<Fame>();
        }
        if (i % 3 == 2) {
            fame.end();
        }
        wanted.world->step();
        unwanted.world->step();
        EXPECT_EQ(wanted.world->stateHash(), unwanted.world->stateHash());
    }
}

} // namespace
} // namespace on_demand_test
} // namespace trembler
