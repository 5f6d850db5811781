// Objects created and destroyed by calls: their ids and names do not depend on the order of the calls.
#include "runtime/placement.hpp"
#include "runtime/population/population_resolver.hpp"
#include "runtime/world/world.hpp"
#include "tests/support/sanitizer.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <set>

namespace trembler {
namespace {

/// Orders of births and deaths for its owner, in any order.
struct Orders {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Orders", "orders", "What the object wants to come and go."};
    std::vector<std::int32_t> births; ///< numbers
    std::vector<ObjectId> deaths;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "births", .unit = "", .meaning = "births"}, self.births);
        visit(FieldInfo{.key = "deaths", .unit = "", .meaning = "deaths"}, self.deaths);
    }
};

template <int n>
struct FromOrders final : Interaction<FromOrders<n>, PopulationRole, Reads<Orders>> {
    static constexpr ComponentText text{.name =
                                            n == 0 ? "Population <- Orders" : "Population <- Orders again",
                                        .effect = "population",
                                        .level = "",
                                        .work = "Passes the orders on."};
    using Activation = NeedsAll<Orders>;
    using Access = typename Interaction<FromOrders, PopulationRole, Reads<Orders>>::Access;
    using Caller = typename Interaction<FromOrders, PopulationRole, Reads<Orders>>::Caller;
    void apply(Access& access) {
        auto const& orders = access.template read<Orders>();
        access.forChunks(orders.size(), [&](Caller& caller, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                for (std::int32_t const number : orders.values()[i].births) {
                    caller.call(CreateObject{.prototype = 0,
                                             .position = {1.0 * number, 0},
                                             .angle = 0,
                                             .velocity = {0, 1},
                                             .spin = 0,
                                             .maker = orders.owners()[i],
                                             .number = static_cast<std::uint64_t>(number)});
                }
                for (ObjectId const id : orders.values()[i].deaths) {
                    caller.call(DestroyObject{id});
                }
            }
        });
    }
};

void addBall(World& world) {
    Prototype ball;
    ball.name = "ball";
    ball.values.push_back(
        std::make_unique<ValueOf<Rotation>>(Rotation{9})); // the angle of the call takes precedence
    ASSERT_EQ(world.store().prototypes().add(std::move(ball)), 0U);
}
Registry const& rules() {
    static Registry const registry = [] {
        Registry made;
        registerRuntime(made);
        made.component<FromOrders<0>>();
        made.component<FromOrders<1>>(); // so every order comes from two interactions
        return made;
    }();
    return registry;
}
void order(World& world, ObjectId maker, std::vector<std::int32_t> births,
           std::vector<ObjectId> deaths = {}) {
    world.store().column<Orders>().set(maker, {std::move(births), std::move(deaths)});
}

TEST(Population, MakesOneObjectForEqualKeysFromThePrototypeAndTheCall) {
    World world(rules(), {.threads = 1, .detail = {}, .periods = {}, .trace = true});
    addBall(world);
    ObjectId const gun = world.store().create("gun");
    order(world, gun, {4, 4});
    world.start();
    world.step();
    EXPECT_EQ(world.store().objects().size(), 1U) << "a call is carried out in the next frame";
    world.step();
    ASSERT_EQ(world.store().objects().size(), 2U);
    ObjectId const ball = world.store().find("ball of gun 4");
    ASSERT_TRUE(ball.valid());
    EXPECT_EQ(world.find<Position>(ball)->value, (Vec2{4, 0}));
    EXPECT_EQ(world.find<Velocity>(ball)->value, (Vec2{0, 1}));
    EXPECT_EQ(world.find<Rotation>(ball)->angle, 0);
    EXPECT_EQ(world.find<PopulationChanges>()->created, std::vector{ball});
    EXPECT_EQ(world.store().originOf(ball), (Origin{Origin::Kind::birth, 0, 4, gun}));
    EXPECT_EQ(world.store().prototypeOf(ball)->name, "ball");
    world.step();
    EXPECT_TRUE(world.find<PopulationChanges>()->created.empty()) << "changes are offered for one frame";
    EXPECT_EQ(world.store().objects().size(), 2U);
}

TEST(Population, MakesNothingFromAPrototypeOfSeveralPieces) {
    World world(rules());
    Prototype cart;
    cart.name = "cart";
    cart.composite = true;
    world.store().prototypes().add(std::move(cart));
    order(world, world.store().create("gun"), {1});
    world.start();
    world.step();
    world.step();
    EXPECT_EQ(world.store().objects().size(), 1U);
}

TEST(Population, AnotherBirthOfTheSameNumberGetsADifferentName) {
    World world(rules());
    addBall(world);
    ObjectId const gun = world.store().create("gun");
    order(world, gun, {1});
    world.start();
    world.step();
    order(world, gun, {1}); // in another frame: another birth
    world.step();
    world.step();
    EXPECT_TRUE(world.store().find("ball of gun 1").valid());
    EXPECT_TRUE(world.store().find("ball of gun 1 (2)").valid());
}

TEST(Population, ReusesIndicesWithTheNextGeneration) {
    World world(rules());
    addBall(world);
    ObjectId const gun = world.store().create("gun");
    ObjectId const old = world.store().create("old");
    ObjectId const last = world.store().create("last");
    order(world, gun, {1, 2}, {old});
    world.start();
    world.step();
    world.step(); // indices are freed before new objects are created
    EXPECT_FALSE(world.store().alive(old));
    EXPECT_EQ(world.store().find("ball of gun 1"), (ObjectId{old.index, old.generation + 1}));
    EXPECT_EQ(world.store().find("ball of gun 2"), (ObjectId{last.index + 1, 0}));
    EXPECT_EQ(world.find<PopulationChanges>()->destroyed, std::vector{old});
}

TEST(Population, SecondDestructionsAndInvalidIdsHaveNoEffect) {
    World world(rules(), {.threads = 1, .detail = {}, .periods = {}, .trace = true});
    addBall(world);
    ObjectId const gun = world.store().create("gun");
    ObjectId const crate = world.store().create("crate");
    order(world, gun, {}, {crate, crate, ObjectId{55, 3}, ObjectId{}});
    world.start();
    world.step();
    world.step();
    EXPECT_EQ(world.find<PopulationChanges>()->destroyed, std::vector{crate});
    EXPECT_EQ(world.store().objects().size(), 1U);
    std::size_t deaths = 0;
    for (Event const& event : world.tracer()->events()) {
        if (event.event == "destroyed") {
            ++deaths;
            EXPECT_EQ(event.objects, std::vector<std::string>{"crate"}) << "the event has the object's name";
            EXPECT_EQ(event.causes.size(), 4U) << "all calls for it are causes";
        }
    }
    EXPECT_EQ(deaths, 1U);
}

TEST(Population, ListsDestroyedObjectsOnceInAscendingOrder) {
    World world(rules(), {.threads = 1, .detail = {}, .periods = {}, .trace = true});
    ObjectId const gun = world.store().create("gun");
    ObjectId const a = world.store().create("a");
    ObjectId const b = world.store().create("b");
    order(world, gun, {}, {b, a, b});
    world.start();
    world.step();
    world.step();
    EXPECT_EQ(world.find<PopulationChanges>()->destroyed, (std::vector{a, b}));
    std::vector<std::string> reported;
    for (Event const& event : world.tracer()->events()) {
        if (event.event == "destroyed") {
            reported.push_back(event.objects.front());
        }
    }
    EXPECT_EQ(reported, (std::vector<std::string>{"a", "b"}));
}

TEST(Population, ABirthNamesAMakerThatIsDestroyedInTheSameFrame) {
    World world(rules());
    addBall(world);
    ObjectId const egg = world.store().create("egg");
    order(world, egg, {1}, {egg});
    world.start();
    world.step();
    world.step();
    EXPECT_FALSE(world.store().alive(egg));
    ObjectId const ball = world.store().find("ball of egg 1");
    ASSERT_TRUE(ball.valid());
    EXPECT_EQ(world.store().originOf(ball).maker, egg) << "although this object was removed";
}

struct BadBirth final : Interaction<BadBirth, PopulationRole, Reads<Orders>> {
    static constexpr ComponentText text{.name = "Population <- Nonsense",
                                        .effect = "population",
                                        .level = "",
                                        .work = "Asks for the impossible."};
    using Activation = NeedsAll<Orders>;
    void apply(Access& access) {
        double const nan = std::numeric_limits<double>::quiet_NaN();
        double const infinity = std::numeric_limits<double>::infinity();
        ObjectId const maker = access.read<Orders>().owners().front();
        access.call(CreateObject{77, {}, 0, {}, 0, maker, 1});
        access.call(CreateObject{0, {nan, 0}, 0, {}, 0, maker, 2});
        access.call(CreateObject{0, {}, nan, {}, 0, maker, 3});
        access.call(CreateObject{0, {}, 0, {0, infinity}, 0, maker, 4});
        access.call(CreateObject{0, {}, 0, {}, infinity, maker, 5});
        access.call(CreateObject{0, {}, 0, {}, 0, maker, 6});
    }
};

TEST(Population, RefusesUnknownPartsAndNumbersThatAreNotFinite) {
    Registry registry;
    registerRuntime(registry);
    registry.component<BadBirth>();
    World world(registry);
    addBall(world);
    order(world, world.store().create("gun"), {});
    world.start();
    world.step();
    world.step();
    EXPECT_EQ(world.store().objects().size(), 2U);
    EXPECT_TRUE(world.store().find("ball of gun 6").valid());
}

// Thousands of births and deaths, ordered in any order, on any number of threads, by makers that received
// their orders in any order: the same ids, names and bits.
TEST(PopulationParallel, DoesNotDependOnThreadsOrOrder) {
    constexpr std::uint32_t makers = 3000;
    std::set<std::uint64_t> hashes;
    for (unsigned seed = 0; seed < (test::underSanitizer ? 2 : 3); ++seed) {
        for (int const threads : test::underSanitizer ? std::vector{1, 8} : std::vector{1, 2, 8}) {
            World world(rules(), {.threads = threads, .detail = {}, .periods = {}});
            addBall(world);
            std::vector<ObjectId> ids;
            for (std::uint32_t i = 0; i < makers; ++i) {
                ids.push_back(world.store().create("maker " + std::to_string(i)));
                world.store().column<Orders>().set(ids.back(), {});
            }
            std::mt19937 random(seed);
            for (std::uint32_t i = 0; i < makers; ++i) {
                std::vector<std::int32_t> births = {1, 2, 3};
                std::shuffle(births.begin(), births.end(), random);
                std::vector<ObjectId> deaths;
                if (i % 4 == 0) {
                    deaths = {ids[i], ids[(i * 7 + 1) % makers]};
                    std::shuffle(deaths.begin(), deaths.end(), random);
                }
                // Once with shuffled orders; the orders themselves must not be part of the comparison.
                order(world, ids[i], births, deaths);
            }
            world.start();
            world.step();
            world.step();
            EXPECT_EQ(world.find<PopulationChanges>()->created.size(), 3U * makers);
            EXPECT_GT(world.find<PopulationChanges>()->destroyed.size(), makers / 4);
            for (ObjectId const id : ids) {
                world.store().column<Orders>().remove(id);
            }
            world.step(); // carries out, or drops, the waiting calls, which are in the order of the orders
            hashes.insert(world.stateHash());
            std::set<std::string> names;
            for (Name const& name : world.store().column<Name>().values()) {
                EXPECT_TRUE(names.insert(name.value).second) << name.value << " twice";
            }
        }
    }
    EXPECT_EQ(hashes.size(), 1U);
}

} // namespace
} // namespace trembler
