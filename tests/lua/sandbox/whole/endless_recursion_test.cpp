// A script whose functions call one another without end: its message and its calls name the place, though
// there are too many calls to state them all.
#include "lua/sandbox/sandbox.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace trembler::lua {
namespace {

ScriptError errorOf(std::string const& chunk, Trust trust) {
    ScriptLimits limits;
    limits.instructions = 1'000'000;
    Sandbox sandbox(limits, trust);
    if (auto refused = sandbox.load(chunk, "deep.lua")) {
        return *refused;
    }
    auto const failed = sandbox.turn(1, [&](lua_State* L) {
        sandbox.pushChunk(L);
        sandbox.callScript(L, 0, 0);
    });
    return failed.value_or(ScriptError{});
}

TEST(EndlessRecursion, HasThePlaceInItsMessageAndItsCalls) {
    std::string const chunk = "local function f(n)\n  local m = n + 1\n  return 1 + f(m)\nend\n\nf(1)";
    for (Trust const trust : {Trust::untrusted, Trust::trusted}) {
        ScriptError const failed = errorOf(chunk, trust);
        EXPECT_TRUE(failed.limit);
        EXPECT_TRUE(failed.message.starts_with("deep.lua:")) << failed.message;
        EXPECT_NE(failed.message.find("the script calls itself too deeply"), std::string::npos);
        EXPECT_NE(failed.traceback.find("deep.lua:3"), std::string::npos) << failed.traceback;
        EXPECT_TRUE(failed.traceback.ends_with("...\n")) << failed.traceback;
        EXPECT_LE(std::count(failed.traceback.begin(), failed.traceback.end(), '\n'), 3) << failed.traceback;
    }
}

TEST(EndlessRecursion, NamesTheFunctionsThatCallOneAnother) {
    std::string const chunk = "local odd\nlocal function even(n)\n  return 1 + odd(n + 1)\nend\n"
                              "odd = function(n)\n  return 1 + even(n + 1)\nend\neven(1)";
    for (Trust const trust : {Trust::untrusted, Trust::trusted}) {
        ScriptError const failed = errorOf(chunk, trust);
        EXPECT_NE(failed.traceback.find("deep.lua:3, in the function of line 2\n"), std::string::npos);
        EXPECT_NE(failed.traceback.find("deep.lua:6, in the function of line 5\n"), std::string::npos);
        EXPECT_LE(std::count(failed.traceback.begin(), failed.traceback.end(), '\n'), 13) << failed.traceback;
    }
}

// Calls of one place that follow one another are one line, and the others are there.
TEST(EndlessRecursion, OfFewCallsIsShownWhole) {
    std::string const chunk =
        "local function f(n)\n  if n == 0 then error('enough') end\n  return 1 + f(n - 1)\nend\n\nf(50)";
    for (Trust const trust : {Trust::untrusted, Trust::trusted}) {
        ScriptError const failed = errorOf(chunk, trust);
        EXPECT_EQ(failed.message, "deep.lua:2: enough");
        EXPECT_EQ(failed.traceback, "deep.lua:2\ndeep.lua:3\ndeep.lua:6\n");
    }
}

// What the script was doing when it was stopped again says nothing about the recursion.
TEST(EndlessRecursion, ThatIsCaughtHasNoCallsOfTheCatcher) {
    std::string const chunk =
        "local function f(n)\n  return 1 + f(n + 1)\nend\nlocal good = pcall(f, 1)\nwhile "
        "true do end";
    for (Trust const trust : {Trust::untrusted, Trust::trusted}) {
        ScriptError const failed = errorOf(chunk, trust);
        EXPECT_TRUE(failed.limit);
        EXPECT_EQ(failed.traceback.find("deep.lua:4"), std::string::npos) << failed.traceback;
    }
}

} // namespace
} // namespace trembler::lua
