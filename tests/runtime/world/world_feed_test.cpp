// Calls from outside a world: only for roles that declare it, recorded and drained like other calls.
#include "runtime/input/input_resolver.hpp"
#include "tests/runtime/world/heat.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

using heat::Heat;

/// A bell that a visitor pulls, once or several times, and that heat rings as well.
struct Ring {
    static constexpr CallText text{"ring", "(number)", "Rings."};
    static constexpr Algebra algebra = Algebra::sequence;
    int number = 0;
    [[nodiscard]] std::array<ObjectId, 0> objects() const { return {}; }
};
struct Chime {
    static constexpr CallText text{"chime", "(object, amount)", "Chimes."};
    static constexpr Algebra algebra = Algebra::sumOfAmounts;
    ObjectId object;
    int amount = 0;
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "object", .unit = "", .meaning = "the object", .required = true}, self.object);
        visit(FieldInfo{.key = "amount", .unit = "", .meaning = "how often", .required = true}, self.amount);
    }
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {object}; }
};
struct BellRole {
    static constexpr std::string_view name = "Bell";
    static constexpr std::string_view fedBy = "the visitor";
    using Calls = CallList<Ring, Chime>;
};
struct BellLog {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{"Bell log", "bell_log", "The calls that the bell received."};
    static constexpr Coverage coverage = hashed;
    static constexpr std::string_view standing = "kept over all parts";
    std::vector<int> rings;
    std::vector<std::string> by;
    int chimes = 0;
};
struct Bell final : Resolver<Bell, BellRole, Reads<Heat>, Writes<>, Provides<BellLog>> {
    static constexpr ComponentText text{.name = "Bell", .effect = "bell", .level = "", .work = "Rings."};
    using Activation = NeedsAny<Heat>;
    void advance(Access& access) {
        BellLog& log = access.provide<BellLog>();
        access.forCalls<Ring>([&](Ring const& call, CallOrigin const& origin) {
            log.rings.push_back(call.number);
            log.by.emplace_back(origin.caller.name());
        });
        access.forCalls<Chime>([&](Chime const& call, CallOrigin const& origin) {
            log.chimes += call.amount;
            log.by.emplace_back(origin.caller.name());
        });
    }
};
struct BellFromHeat final : Interaction<BellFromHeat, BellRole, Reads<Heat>> {
    static constexpr ComponentText text{
        .name = "Bell <- Heat", .effect = "bell", .level = "", .work = "Chimes when heat changes."};
    using Activation = NeedsAny<Heat>;
    void apply(Access& access) {
        for (ObjectId const id : access.read<Heat>().owners()) {
            access.call(Chime{id, 1});
        }
    }
};

struct Porch {
    Registry registry;
    std::unique_ptr<World> world;
    ObjectId stone;
    explicit Porch(bool bell = true) {
        registry.component<heat::Stove>();
        registry.component<BellFromHeat>(); // may be registered before its resolver
        if (bell) {
            registry.component<Bell>();
        }
        world = std::make_unique<World>(registry);
        stone = world->store().create("stone");
        world->store().column<Heat>().set(stone, {1});
    }
    [[nodiscard]] BellLog const& log() const { return *world->find<BellLog>(); }
};

TEST(FedFromOutside, IsCarriedOutOnceInTheNextFrameInTheOrderOfFeeding) {
    Porch porch;
    porch.world->start();
    porch.world->step();
    for (int const number : {3, 1, 2}) {
        porch.world->feed<BellRole>(Ring{number});
    }
    EXPECT_TRUE(porch.log().rings.empty());
    porch.world->step();
    EXPECT_EQ(porch.log().rings, (std::vector<int>{3, 1, 2}));
    porch.world->step();
    porch.world->step();
    EXPECT_EQ(porch.log().rings.size(), 3U);
}

TEST(FedFromOutside, ComesBeforeAllInteractionsWithASeparateName) {
    Porch porch;
    porch.world->start();
    porch.world->step(); // the interaction makes its first call
    porch.world->feed<BellRole>(Chime{porch.stone, 10});
    porch.world->step();
    EXPECT_EQ(porch.log().chimes, 11);
    EXPECT_EQ(porch.log().by, (std::vector<std::string>{"the visitor", "Bell <- Heat"}));
}

TEST(FedFromOutside, IsDroppedWithoutAResolver) {
    Porch porch;
    porch.world->feed<BellRole>(Ring{1}); // before start()
    porch.world->start();
    porch.world->step();
    EXPECT_TRUE(porch.log().rings.empty());
    porch.world->store().column<Heat>().remove(porch.stone);
    porch.world->step(); // nothing activates the bell any more
    porch.world->feed<BellRole>(Ring{2});
    porch.world->step();
    porch.world->store().column<Heat>().set(porch.stone, {1});
    porch.world->step();
    porch.world->step();
    EXPECT_TRUE(porch.log().rings.empty());
    Porch silent(false);
    silent.world->start();
    silent.world->feed<BellRole>(Ring{1});
    EXPECT_NO_THROW(silent.world->step());
}

TEST(FedFromOutside, IsKeptWhenComponentsAreConstructedBeforeTheNextFrame) {
    Porch porch;
    porch.world->start();
    porch.world->step();
    porch.world->feed<BellRole>(Ring{7});
    Subscription const log = porch.world->want<heat::StoveLog>(); // all are bound again
    porch.world->step();
    EXPECT_EQ(porch.log().rings, std::vector<int>{7});
}

// The player's input uses such a role.
TEST(FedFromOutside, IncludesThePlayersInput) {
    static_assert(FedFromOutside<PlayerRole>);
    static_assert(!FedFromOutside<heat::HeatRole>);
    EXPECT_EQ(PlayerRole::fedBy, "the player");
}

} // namespace
} // namespace trembler
