// Changes of a running world by name: what they set, and the changes between two sets of options.
#include "runtime/level/model/world_change.hpp"
#include "tests/runtime/level/model/bakery.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace trembler {
namespace world_change_test {
namespace {

using namespace bakery;

int periodIn(World const& world, std::string const& component) {
    for (ComponentStatus const& status : world.status()) {
        if (title(*status.info) == component) {
            return status.period;
        }
    }
    return 0;
}

/// The component that computes the browning now.
std::string bakingIn(World const& world) {
    std::string found;
    for (ComponentStatus const& status : world.status()) {
        if (status.info->text.effect == "baking" && status.activity != Activity::absent) {
            found += status.info->text.name;
        }
    }
    return found;
}

TEST(WorldChange, ASettingSetsItsFieldAndNoOther) {
    Bakery made;
    World& world = made.world;
    apply(bakeryRegistry(), world, settingTo("oven", "layers", 8));
    Oven const* oven = world.find<Oven>(made.owner);
    ASSERT_NE(oven, nullptr);
    EXPECT_EQ(oven->layers, 8);
    EXPECT_EQ(oven->tolerance, 0.5);
    apply(bakeryRegistry(), world, settingTo("oven", "tolerance", 0.25));
    oven = world.find<Oven>(made.owner);
    EXPECT_EQ(oven->layers, 8);
    EXPECT_EQ(oven->tolerance, 0.25);
    EXPECT_EQ(oven->heat, 200);
    EXPECT_FALSE(oven->fan);
}

TEST(WorldChange, ASettingThatTheWorldDoesNotStateStartsFromTheDefault) {
    Bakery made;
    World& world = made.world;
    world.store().column<Oven>().remove(made.owner);
    EXPECT_TRUE(holds(bakeryRegistry(), world, settingTo("oven", "tolerance", 0.5)));
    EXPECT_FALSE(holds(bakeryRegistry(), world, settingTo("oven", "tolerance", 0.25)));
    EXPECT_EQ(world.find<Oven>(made.owner), nullptr) << "a question changes nothing";
    apply(bakeryRegistry(), world, settingTo("oven", "tolerance", 0.25));
    ASSERT_NE(world.find<Oven>(made.owner), nullptr);
    EXPECT_EQ(world.find<Oven>(made.owner)->tolerance, 0.25);
    EXPECT_EQ(world.find<Oven>(made.owner)->heat, 200);
}

TEST(WorldChange, APeriodAndADetailLevelCountInTheWorld) {
    Bakery made;
    World& world = made.world;
    EXPECT_EQ(bakingIn(world), "Rough Baking") << "the level of the least rank";
    apply(bakeryRegistry(), world, detailTo("baking", "exact"));
    apply(bakeryRegistry(), world, periodTo("Exact Baking DPS", 4));
    world.step();
    EXPECT_EQ(bakingIn(world), "Exact Baking");
    EXPECT_EQ(periodIn(world, "Exact Baking DPS"), 4);
    EXPECT_EQ(periodIn(world, "Timer DPS"), 3);
    apply(bakeryRegistry(), world, detailTo("baking", ""));
    world.step();
    EXPECT_EQ(bakingIn(world), "Rough Baking");
}

TEST(WorldChange, WhatIsRefusedChangesNothing) {
    Bakery made({}, true);
    World& world = made.world;
    std::uint64_t const before = world.stateHash();
    for (RecordedChange const& change :
         {settingTo("oven", "layers", 17), settingTo("oven", "heat", 180), settingTo("oven", "fan", 1),
          settingTo("oven", "tolerance", std::numeric_limits<double>::quiet_NaN()),
          settingTo("ovn", "layers", 2), periodTo("Exact Baking DPS", 5), periodTo("Timer DPS", 1),
          periodTo("Nothing DPS", 2), detailTo("baking", "rough"), detailTo("baking", "laboratory"),
          detailTo("frying", "exact")}) {
        EXPECT_FALSE(holds(bakeryRegistry(), world, change)) << inWords(change);
        EXPECT_THROW(apply(bakeryRegistry(), world, change), std::invalid_argument) << inWords(change);
        EXPECT_EQ(world.stateHash(), before) << inWords(change);
    }
}

TEST(WorldChange, AfterAChangeItHoldsAndRepeatingItChangesNothing) {
    EXPECT_TRUE(rc::check("random changes, one after the other", [] {
        auto const below = [](int bound) {
            return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, bound));
        };
        Bakery made;
        World& world = made.world;
        for (int i = 1 + below(8); i > 0; --i) {
            std::vector<RecordedChange> const some{
                settingTo("oven", "layers", below(17)), settingTo("oven", "tolerance", (1 + below(8)) / 8.0),
                periodTo("Exact Baking DPS", 1 + below(4)),
                detailTo("baking", below(2) == 0 ? "exact" : "rough"), detailTo("baking", "")};
            RecordedChange const& change = some[static_cast<std::size_t>(below(5))];
            bool const held = holds(bakeryRegistry(), world, change);
            std::uint64_t const before = world.stateHash();
            apply(bakeryRegistry(), world, change);
            RC_ASSERT(holds(bakeryRegistry(), world, change));
            std::uint64_t const once = world.stateHash();
            RC_ASSERT(!held || once == before);
            apply(bakeryRegistry(), world, change);
            RC_ASSERT(world.stateHash() == once);
        }
    }));
}

// The reference is a world that had the other options from its start.
TEST(WorldChange, DifferencesLeadFromOneSetOfOptionsToTheOther) {
    EXPECT_TRUE(rc::check("random options", [] {
        auto const below = [](int bound) {
            return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, bound));
        };
        auto const random = [&] {
            WorldOptions options;
            if (int const level = below(3); level > 0) {
                options.detail["baking"] = level == 1 ? "exact" : "rough";
            }
            if (int const period = below(5); period > 0) {
                options.periods["Exact Baking DPS"] = period;
            }
            if (below(2) == 0) {
                options.periods["Timer DPS"] = 3; // stated, although it is the usual one
            }
            return options;
        };
        WorldOptions const from = random();
        WorldOptions const to = random();
        RC_ASSERT(differences(bakeryRegistry(), from, from).empty());
        Bakery changed(from);
        Bakery const reference(to);
        std::vector<RecordedChange> const changes = differences(bakeryRegistry(), from, to);
        for (RecordedChange const& change : changes) {
            RC_ASSERT(!holds(bakeryRegistry(), changed.world, change)); // none of them is superfluous
            apply(bakeryRegistry(), changed.world, change);
        }
        RC_ASSERT(changed.world.options().detail == reference.world.options().detail);
        RC_ASSERT(bakingIn(changed.world) == bakingIn(reference.world));
        for (char const* const component : {"Exact Baking DPS", "Rough Baking DPS", "Timer DPS"}) {
            RC_ASSERT(periodIn(changed.world, component) == periodIn(reference.world, component));
        }
        RC_CLASSIFY(!changes.empty(), "they differ");
    }));
}

TEST(WorldChange, InWordsNamesTheSubjectAndTheValue) {
    EXPECT_EQ(inWords(detailTo("baking", "exact")), "baking: exact");
    EXPECT_EQ(inWords(detailTo("baking", "")), "baking: as the scene needs it");
    EXPECT_EQ(inWords(periodTo("Timer DPS", 3)), "Timer DPS: every 3 frames");
    EXPECT_EQ(inWords(settingTo("oven", "tolerance", 0.25)), "oven: tolerance 0.25");
}

} // namespace
} // namespace world_change_test
} // namespace trembler
