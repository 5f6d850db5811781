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

// The first frames of each play; the page is made from all of them.
TEST(InteractionsInLua, HashesAreAsThePageSays) {
    GameData const data;
    std::uint64_t const frames = test::underSanitizer ? 30 : 100;
    std::ifstream file(std::filesystem::path(TREMBLER_SOURCE_DIR) / "docs/scripting-analysis.md");
    std::string const page{std::istreambuf_iterator<char>(file), {}};
    for (Comparison const& comparison : compareAll(data, comparedLevels(data), frames)) {
        for (std::string const& error : comparison.errors) {
            ADD_FAILURE() << comparison.name << ": " << error;
        }
        std::size_t const row = page.find("| " + comparison.name + " |");
        ASSERT_NE(row, std::string::npos) << comparison.name << " is missing on the page";
        std::string const line = page.substr(row, page.find('\n', row) - row);
        bool const equal = line.find("| equal |") != std::string::npos;
        if (equal || comparison.plays == 0) {
            EXPECT_FALSE(comparison.firstDiffers.has_value())
                << comparison.name << ": " << comparison.differsIn << " in frame "
                << comparison.firstDiffers.value_or(0);
        }
    }
}

} // namespace
} // namespace trembler::lua::analysis
