// The look of an object does not influence the simulation.
#include "physics/look.hpp"
#include "runtime/property/state_hash.hpp"
#include "tests/support/experiment.hpp"

#include <algorithm>

namespace trembler {
namespace {

class LookTest : public Experiment {};

// By construction: a property that no component, completion or rule reads cannot influence anything.
TEST_F(LookTest, IsReadByNoComponent) {
    auto const isLook = [](PropertyInfo const* info) { return info->type == typeid(Look); };
    for (Registration const& registration : gameData().registry.components()) {
        ComponentInfo const& info = *registration.info;
        for (auto const* list : {&info.reads, &info.writes, &info.neededAll, &info.neededAny}) {
            EXPECT_TRUE(std::none_of(list->begin(), list->end(), isLook)) << title(info);
        }
    }
    for (CompletionInfo const* info : gameData().registry.completions()) {
        for (auto const* list : {&info->reads, &info->adds, &info->neededAll, &info->neededAny}) {
            EXPECT_TRUE(std::none_of(list->begin(), list->end(), isLook)) << title(*info);
        }
    }
}

/// The hash of everything except looks.
std::uint64_t hashOf(World const& world) {
    StateHash hash;
    for (ColumnBase const* column : world.store().columns()) {
        if (column->info().type != typeid(Look)) {
            column->hash(hash);
        }
    }
    return hash.digest();
}

// A level with sound sensors, wires and magnets runs in the same way with other looks.
TEST_F(LookTest, OfAllObjectsCanBeChangedWithoutInfluence) {
    for (char const* const file :
         {"../sound/1-loud-enough.json", "1-switched-electromagnet.json", "4-raft.json"}) {
        LevelFile level = load(file);
        std::string const solution = level.solutions.front().name;
        std::vector<std::uint64_t> hashes;
        for (LookPattern const pattern : {LookPattern::own, LookPattern::rubber, LookPattern::steel}) {
            for (LevelObject& object : level.objects) {
                object.properties.set(Look{pattern, "#123456", "x"});
            }
            open(level, solution);
            runTo(180);
            hashes.push_back(hashOf(world()));
        }
        EXPECT_EQ(hashes[1], hashes[0]) << file;
        EXPECT_EQ(hashes[2], hashes[0]) << file;
    }
}

} // namespace
} // namespace trembler
