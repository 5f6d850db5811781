// The program's interactions in C++ and the same in Lua: docs/scripting-analysis.md describes the comparison.
#include "puzzle/data/effects.hpp"
#include "tests/lua/analysis/comparison.hpp"
#include "tests/lua/analysis/interaction_tables.hpp"
#include "tests/lua/support/script_world.hpp"
#include "tests/support/attempts.hpp"
#include "tests/support/sanitizer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>

namespace trembler::lua::analysis {
namespace {

bool equalOnThePage(std::string const& name) {
    static std::string const page = [] {
        std::ifstream file(std::filesystem::path(TREMBLER_SOURCE_DIR) / "docs/scripting-analysis.md");
        return std::string{std::istreambuf_iterator<char>(file), {}};
    }();
    std::size_t const row = page.find("| " + name + " |");
    EXPECT_NE(row, std::string::npos) << name << " is missing on the page";
    return row != std::string::npos &&
           page.substr(row, page.find('\n', row) - row).find("| equal |") != std::string::npos;
}

void expectNoErrors(Comparison const& comparison, bool equal) {
    for (std::string const& error : comparison.errors) {
        ADD_FAILURE() << comparison.name << ": " << error;
    }
    EXPECT_FALSE(equal && comparison.firstDiffers.has_value())
        << comparison.name << ": " << comparison.differsIn << " in frame "
        << comparison.firstDiffers.value_or(0);
}

/// All scripts that the page calls equal in one world, which is a run of each play instead of one for each
/// interaction, and the others in another.
void compareOverall(GameData const& data, std::uint64_t frames) {
    std::vector<Counterpart> equal;
    std::vector<Counterpart> others;
    for (Counterpart const& counterpart : counterparts()) {
        if (!counterpart.script.empty()) {
            (equalOnThePage(counterpart.name) ? equal : others).push_back(counterpart);
        }
    }
    ASSERT_GT(equal.size(), 10U);
    Comparison const compared = compareTogether(data, comparedLevels(data), frames, equal);
    EXPECT_GE(compared.plays, static_cast<int>(data.levels().size()));
    expectNoErrors(compared, true);
    expectNoErrors(compareTogether(data, comparedLevels(data), frames, others), false);
}

TEST(InteractionsInLua, NoInteractionIsLeftOut) {
    Registry registry;
    registerEffects(registry);
    std::vector<std::string> registered;
    for (Registration const& registration : registry.components()) {
        if (registration.info->kind == ComponentKind::interaction) {
            registered.emplace_back(registration.info->text.name);
        }
    }
    std::vector<std::string> listed;
    for (Counterpart const& counterpart : counterparts()) {
        listed.push_back(counterpart.name);
    }
    std::sort(registered.begin(), registered.end());
    std::sort(listed.begin(), listed.end());
    EXPECT_EQ(listed, registered);
}

TEST(InteractionsInLua, NoScriptIsLeftOut) {
    std::set<std::filesystem::path> used;
    for (Counterpart const& counterpart : counterparts()) {
        used.insert(counterpart.script.filename());
        EXPECT_GT(nativeLines(counterpart), 5) << counterpart.name;
    }
    for (auto const& entry : std::filesystem::directory_iterator(std::filesystem::path(TREMBLER_SOURCE_DIR) /
                                                                 "tests/lua/analysis/interactions")) {
        EXPECT_TRUE(used.contains(entry.path().filename())) << entry.path();
    }
}

// A script in place of an interaction that runs inside a derived property set (5.7.3) reads the values that
// the set has just derived, and sleeps with it.
TEST(InteractionsInLua, RunInsideADerivedPropertySetWhereTheNativeOneDoes) {
    std::vector<Counterpart> const all = counterparts();
    auto const gravity = std::find_if(
        all.begin(), all.end(), [](Counterpart const& each) { return each.name == "Dynamics <- Gravity"; });
    ASSERT_NE(gravity, all.end());
    auto const log = std::make_shared<ScriptLog>();
    std::vector<std::vector<std::uint64_t>> hashes;
    std::vector<std::uint64_t> updates;
    for (bool const scripted : {false, true}) {
        Registry registry;
        registerEffects(registry);
        if (scripted) {
            putInPlace(registry, *gravity, log);
        }
        ASSERT_FALSE(registry.shortcuts().empty());
        World world(registry);
        Store& store = world.store();
        ObjectId const field = store.create("world");
        store.column<GravityField>().set(field, {{0, -9.81}});
        ObjectId const box = addBox(store, "box", {0, 0});
        (void)addBox(store, "other", {5, 0}, {1, 0});
        world.start();
        hashes.emplace_back();
        for (int frame = 0; frame < 30; ++frame) {
            if (frame == 10) {
                store.column<Mass>().set(box, {700});
            } else if (frame == 20) {
                store.column<GravityField>().set(field, {{1, -3}});
            }
            world.step();
            hashes.back().push_back(propertyHash(world, registry));
        }
        updates.push_back(statusOf(world, "Dynamics <- Gravity").updates);
        EXPECT_EQ(updates.back(), 3U) << "once, and after each change";
        EXPECT_NEAR(world.find<Velocity>(box)->value.x, 1.0 / 6, 0.02);
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_TRUE(log->take().empty());
}

// The first frames of each play; the page is made from all of them. With TREMBLER_FUZZ=2 each interaction is
// compared by itself, which also names the one that differs.
TEST(InteractionsInLua, HashesAreAsThePageSays) {
    GameData const data;
    if (test::underSanitizer || test::attempts(1) == 1) {
        compareOverall(data, test::underSanitizer ? 30 : 100);
    } else {
        for (Comparison const& comparison : compareAll(data, comparedLevels(data), 100)) {
            expectNoErrors(comparison, comparison.plays == 0 || equalOnThePage(comparison.name));
        }
    }
}

} // namespace
} // namespace trembler::lua::analysis
