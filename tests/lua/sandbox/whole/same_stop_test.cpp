// A script that reaches a limit of its memory is stopped at the same instruction in every sandbox, whatever
// seed LuaJIT has given to the hashes of its strings, and in every turn.
#include "lua/sandbox/sandbox.hpp"

#include <gtest/gtest.h>

#include <lua.hpp>
#include <set>
#include <tuple>

namespace trembler::lua {
namespace {

struct Case {
    char const* name;
    char const* text;
    bool limit;                  // whether it reaches one
    std::size_t objects = 1'000; // so many that instructions are not the first limit
};

class SameStop : public testing::TestWithParam<Case> {};

std::optional<ScriptError> turnWithObjects(Sandbox& sandbox, std::size_t objects) {
    return sandbox.turn(objects, [&](lua_State* L) {
        sandbox.pushChunk(L);
        sandbox.callScript(L, 0, 0);
    });
}

TEST_P(SameStop, InEverySandboxAndTurn) {
    std::set<std::uint64_t> instructions;
    std::set<std::tuple<int, std::uint64_t, std::size_t, std::string>> seen;
    constexpr int turns = 4;
    for (int state = 0; state < 8; ++state) {
        Sandbox sandbox(ScriptLimits{});
        ASSERT_FALSE(sandbox.load(GetParam().text, "same.lua"));
        for (int turn = 0; turn < turns; ++turn) {
            auto const failed = turnWithObjects(sandbox, GetParam().objects);
            EXPECT_EQ(failed && failed->limit, GetParam().limit) << (failed ? failed->message : "");
            instructions.insert(sandbox.instructions());
            seen.emplace(turn, sandbox.instructions(), sandbox.memory().used(),
                         failed ? failed->message : "");
        }
    }
    EXPECT_EQ(instructions.size(), 1U);
    EXPECT_EQ(seen.size(), static_cast<std::size_t>(turns)); // to the byte
}

INSTANTIATE_TEST_SUITE_P(
    Scripts, SameStop,
    testing::Values(
        Case{"StackOfArguments", "local function f(...) return f(1, ...) end f()", true},
        Case{"StackOfCalls", "local function f() return 1 + f() end f()", true},
        Case{"StackOfACoroutine",
             "local function f() return 1 + f() end coroutine.resume(coroutine.create(f))", true},
        Case{"Tables", "local all = {} for i = 1, 1e6 do all[i % 1000] = { i } end", true},
        Case{"Closures", "local all = {} for i = 1, 1e6 do all[i % 9] = function() return i end end", true},
        Case{"Texts", "local all, i = {}, 0 while true do i = i + 1 all[i % 3000] = 'text' .. i end", true},
        // A few thousand texts are more than LuaJIT's table of texts has room for without growing.
        Case{"SomeTexts", "for i = 1, 6000 do local text = 'text' .. i end", false},
        Case{"SomeTextsWithMetatables",
             "setmetatable({}, {}) for i = 1, 6000 do local text = 'text' .. i end", false},
        Case{"KeysThatComeAndGo", R"lua(
local keys, t = {}, {}
for i = 1, 200 do keys[i] = "k" .. i end
for i = 1, 128 do t[keys[i]] = i end
for i = 1, 1e6 do
  t[keys[(i - 1) % 200 + 1]] = nil
  t[keys[(i + 127) % 200 + 1]] = i
end)lua",
             true, 100}),
    [](auto const& info) { return std::string(info.param.name); });

} // namespace
} // namespace trembler::lua
