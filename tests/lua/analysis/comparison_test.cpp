// The interactions of this program in C++ and the same in Lua: the page docs/scripting-analysis.md says what
// is compared here.
#include "puzzle/data/effects.hpp"
#include "tests/lua/analysis/comparison.hpp"
#include "tests/lua/analysis/interaction_tables.hpp"
#include "tests/support/sanitizer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>

namespace trembler::lua::analysis {
namespace {

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

// The whole comparison, or with sanitizers the first frames of it.
TEST(InteractionsInLua, HashesAreAsThePageSays) {
    GameData const data;
    std::uint64_t const frames = test::underSanitizer ? 60 : 100'000;
    std::vector<Comparison> const compared = compareAll(data, comparedLevels(data), frames);
    for (Comparison const& comparison : compared) {
        for (std::string const& error : comparison.errors) {
            ADD_FAILURE() << comparison.name << ": " << error;
        }
    }
    if (test::underSanitizer) {
        return;
    }
    std::ifstream file(std::filesystem::path(TREMBLER_SOURCE_DIR) / "docs/scripting-analysis.md");
    std::string const page{std::istreambuf_iterator<char>(file), {}};
    std::string const table = hashTable(compared);
    EXPECT_NE(page.find(table), std::string::npos)
        << "docs/scripting-analysis.md has another table; this is the one of today:\n"
        << table;
}

} // namespace
} // namespace trembler::lua::analysis
