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

void expectNoErrorsAndEquality(Comparison const& comparison, bool equal) {
    for (std::string const& error : comparison.errors) {
        ADD_FAILURE() << comparison.name << ": " << error;
    }
    if (equal) {
        EXPECT_FALSE(comparison.firstDiffers.has_value())
            << comparison.name << ": " << comparison.differsIn << " in frame "
            << comparison.firstDiffers.value_or(0);
    }
}

// The first frames of each play; the page is made from all of them. A sanitizer sees every script in every
// play as well where all are in place at once: since each gives the same world as the interaction in C++, all
// of them do.
TEST(InteractionsInLua, HashesAreAsThePageSays) {
    GameData const data;
    auto const levels = comparedLevels(data);
    if (test::underSanitizer) {
        std::vector<Comparison> const compared = compareAll(data, levels, 30, Replaced::allAtOnce);
        ASSERT_EQ(compared.size(), 1U);
        EXPECT_GE(compared[0].plays, static_cast<int>(levels.size()));
        bool allEqual = true;
        for (Counterpart const& counterpart : counterparts()) {
            allEqual = allEqual && (counterpart.script.empty() || equalOnThePage(counterpart.name));
        }
        expectNoErrorsAndEquality(compared[0], allEqual);
        return;
    }
    for (Comparison const& comparison : compareAll(data, levels, 100)) {
        expectNoErrorsAndEquality(comparison, comparison.plays == 0 || equalOnThePage(comparison.name));
    }
}

} // namespace
} // namespace trembler::lua::analysis
