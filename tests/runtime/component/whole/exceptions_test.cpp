// Turns that an exception ends: no call is carried out twice, and none of a turn that failed.
#include "tests/runtime/world/heat.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace trembler {
namespace exceptions_test {
namespace {

using namespace heat;

/// Turns of the interactions below, and advances of the resolver, that will still fail.
int failingTurns = 0;
int failingAdvances = 0;

/// For every object with fuel, a held call and one that is carried out once; fails at the last object.
struct Failing final : Interaction<Failing, HeatRole, Reads<Fuel>> {
    static constexpr ComponentText text{
        .name = "Heat <- Failing", .effect = "heat", .level = "", .work = "Burns and strikes."};
    using Activation = NeedsAll<Fuel>;
    void apply(Access& access) {
        auto const& fuel = access.read<Fuel>();
        bool const fails = failingTurns > 0;
        failingTurns -= fails ? 1 : 0;
        access.forChunks(fuel.size(), [&](Caller& caller, std::size_t begin, std::size_t end) {
            for (std::size_t row = begin; row < end; ++row) {
                caller.call(AddHeat{fuel.owners()[row], fuel.values()[row].rate});
                caller.call(Strike{fuel.owners()[row], 100});
                if (fails && row + 1 == fuel.size()) {
                    throw std::runtime_error("half-way");
                }
            }
        });
    }
};
/// Fails after it has carried out all calls.
struct FailingFurnace final : Resolver<FailingFurnace, HeatRole, Reads<>, Writes<Heat>, Provides<StoveLog>> {
    static constexpr ComponentText text{
        .name = "Failing Furnace", .effect = "heat", .level = "failing", .work = "Heats."};
    using Activation = NeedsAny<Heat>;
    [[nodiscard]] bool restless() const { return true; }
    void advance(Access& access) {
        Stove::carryOut(access);
        if (failingAdvances > 0) {
            --failingAdvances;
            throw std::runtime_error("too late");
        }
    }
};

struct Plan {
    int objects = 2;
    int threads = 1;
    int resolverPeriod = 1;
    bool trace = false;
};

class Turns : public testing::Test {
protected:
    Turns() {
        failingTurns = 0;
        failingAdvances = 0;
        registry_.component<FailingFurnace>();
        registry_.component<Failing>();
    }
    ~Turns() override {
        failingTurns = 0;
        failingAdvances = 0;
    }
    void begin(Plan const& plan) {
        world_.emplace(registry_, WorldOptions{.threads = plan.threads,
                                               .detail = {},
                                               .periods = {{"Failing Furnace", plan.resolverPeriod}},
                                               .trace = plan.trace,
                                               .rowsWorthThreads = 0});
        for (int i = 0; i < plan.objects; ++i) {
            things_.push_back(world_->store().create("thing " + std::to_string(i)));
            world_->store().column<Heat>().set(things_.back(), {0});
            world_->store().column<Fuel>().set(things_.back(), {60}); // 1 J in a frame
        }
        world_->start();
    }
    void step(int n) {
        for (int i = 0; i < n; ++i) {
            world_->step();
        }
    }
    void stepThatFails() { EXPECT_THROW(world_->step(), std::runtime_error); }
    [[nodiscard]] double heatOf(std::size_t i) const { return world_->find<Heat>(things_[i])->value; }

    Registry registry_;
    std::optional<World> world_;
    std::vector<ObjectId> things_;
};

TEST_F(Turns, OfAnInteractionThatFailHaveMadeNoCalls) {
    for (bool const trace : {false, true}) {
        things_.clear();
        begin({.trace = trace});
        failingTurns = 3;
        for (int i = 0; i < 3; ++i) {
            stepThatFails();
        }
        step(1); // it is applied again, as its turn with these changes failed
        EXPECT_EQ(heatOf(0), 0);
        step(1);
        EXPECT_DOUBLE_EQ(heatOf(0), 101);
        EXPECT_DOUBLE_EQ(heatOf(1), 101);
        step(10);
        EXPECT_DOUBLE_EQ(heatOf(0), 111) << "held ever since, and struck once";
        EXPECT_EQ(world_->find<StoveLog>()->onceEver, 2);
    }
}

TEST_F(Turns, OfAnInteractionThatFailWithdrawItsHeldCallsForThatFrame) {
    begin({});
    step(2);
    ASSERT_DOUBLE_EQ(heatOf(0), 101);
    failingTurns = 1;
    world_->store().column<Fuel>().touch();
    stepThatFails();
    ASSERT_DOUBLE_EQ(heatOf(0), 102) << "the resolver's turn came before";
    step(1);
    EXPECT_DOUBLE_EQ(heatOf(0), 102);
    EXPECT_EQ(world_->find<StoveLog>()->held, 0);
    step(1);
    EXPECT_DOUBLE_EQ(heatOf(0), 203);
}

TEST_F(Turns, ThatFailKeepTheCallsOfEarlierTurnsThatWait) {
    begin({.resolverPeriod = 5}); // advances in frames 1, 6 and 11
    step(2);
    failingTurns = 1;
    world_->store().column<Fuel>().touch();
    stepThatFails();
    step(2);
    EXPECT_EQ(heatOf(0), 0);
    step(1);
    EXPECT_EQ(world_->find<StoveLog>()->onceEver, 4) << "those of frames 1 and 4, not of frame 3";
    step(5);
    EXPECT_EQ(world_->find<StoveLog>()->onceEver, 4);
}

TEST_F(Turns, ThatFailInOneOfManyChunksHaveMadeNoCalls) {
    for (int const threads : {1, 2, 8}) {
        things_.clear();
        begin({.objects = 5000, .threads = threads});
        failingTurns = 1;
        stepThatFails();
        step(1);
        EXPECT_EQ(world_->find<StoveLog>()->onceEver, 0) << threads;
        step(5);
        EXPECT_EQ(world_->find<StoveLog>()->onceEver, 5000) << threads;
        EXPECT_EQ(world_->find<StoveLog>()->held, 5000) << threads;
    }
}

TEST_F(Turns, ThatFailLeaveATraceOfTheCallsThatWereMade) {
    begin({.trace = true});
    step(3);
    failingTurns = 1;
    world_->store().column<Fuel>().touch();
    stepThatFails(); // frame 4
    step(2);
    std::map<std::uint64_t, int> struck;  // by frame: calls
    std::map<std::uint64_t, int> heating; // by frame: calls held from then on
    for (Event const& event : world_->tracer()->events()) {
        struck[event.frame] += event.event == "strike" ? 1 : 0;
        heating[event.frame] += event.event == "addHeat" ? 1 : 0;
    }
    std::erase_if(struck, [](auto const& one) { return one.second == 0; });
    std::erase_if(heating, [](auto const& one) { return one.second == 0; });
    std::map<std::uint64_t, int> const expected{{1, 2}, {5, 2}};
    EXPECT_EQ(struck, expected);
    EXPECT_EQ(heating, expected) << "the calls that are held from frame 5 on are new";
}

TEST_F(Turns, OfAResolverThatFailCarryOutNoCallTwice) {
    for (bool const trace : {false, true}) {
        things_.clear();
        begin({.trace = trace});
        step(1);
        failingAdvances = 2;
        stepThatFails();
        stepThatFails();
        step(2);
        EXPECT_EQ(world_->find<StoveLog>()->onceEver, 2);
        EXPECT_DOUBLE_EQ(heatOf(0), 104) << "a held call goes on";
    }
}

} // namespace
} // namespace exceptions_test
} // namespace trembler
