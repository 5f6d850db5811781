#include "lua/sandbox/sandbox.hpp"
#include "lua/sandbox/source/counted_source.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>
#include <lua.hpp>
#include <random>

namespace trembler::lua {
namespace {

CountedSource counted(std::string const& text) {
    std::optional<BlockFault> fault;
    CountedSource made = countSource(text, fault);
    EXPECT_FALSE(fault) << text << ": " << (fault ? fault->message : "");
    return made;
}
std::size_t countersIn(CountedSource const& source) {
    std::size_t count = 0;
    for (std::size_t at = source.text.find("__over()"); at != std::string::npos;
         at = source.text.find("__over()", at + 1)) {
        ++count;
    }
    return count;
}
/// Instructions that a chunk takes, or -1 if it is stopped.
double instructionsOf(std::string const& text, Trust trust = Trust::untrusted) {
    Sandbox sandbox({}, trust);
    auto const refused = sandbox.load(text, "counted.lua");
    EXPECT_FALSE(refused) << text << ": " << (refused ? refused->message : "");
    auto const failed = sandbox.turn(1, [&](lua_State* L) {
        sandbox.pushChunk(L);
        sandbox.callScript(L, 0, 0);
    });
    EXPECT_TRUE(!failed || failed->limit) << text << ": " << failed->message;
    return failed ? -1 : static_cast<double>(sandbox.instructions());
}

TEST(CountedSource, CountsEveryLoopAndFunctionOnce) {
    EXPECT_EQ(countersIn(counted("local x = 3")), 0U);
    EXPECT_EQ(countersIn(counted("while f() do g() end")), 1U);
    EXPECT_EQ(countersIn(counted("for i = 1, 3 do for j = 1, 3 do g() end end")), 2U);
    EXPECT_EQ(countersIn(counted("repeat local x = f() until x")), 1U);
    EXPECT_EQ(countersIn(counted("local function f(a, ...) return a end")), 1U);
    EXPECT_EQ(countersIn(counted("::again:: goto again")), 1U);
    EXPECT_EQ(
        countersIn(counted("local s = 'while true do end' -- while true do end\n--[[ repeat ]] do end")), 1U);
    EXPECT_EQ(countersIn(counted("if a then b() elseif c then d() else e() end")), 0U);
    EXPECT_EQ(countersIn(counted("while (function() return true end)() do break end")), 2U);
}

TEST(CountedSource, LeavesTheCountOfApplyToTheHostWhereNothingElseCanCallIt) {
    std::string const plain =
        "local k = 2\nreturn interaction { name = 'A', apply = function(a, b, c) c.f(a) end }";
    EXPECT_GT(counted(plain).apply, 0U);
    EXPECT_EQ(counted(plain).parameters, 3U);
    EXPECT_EQ(countersIn(counted(plain)), 0U);
    for (std::string const reachable :
         {"local m m = interaction { apply = function() m.apply() end } return m",
          "return interaction { apply = function() end } + other",
          "return interaction { apply = function() end + other }",
          "local function apply() end return interaction { apply = apply }",
          "return interaction { apply = function() end, other = 'apply' }",
          "local interaction = f return interaction { apply = function() end }",
          "return interaction { apply = function() end }(3)",
          "return f(interaction { apply = function() end })",
          "return interaction { { apply = function() end } }"}) {
        EXPECT_EQ(counted(reachable).apply, 0U) << reachable;
        EXPECT_GE(countersIn(counted(reachable)), 1U) << reachable;
    }
}

TEST(CountedSource, KnowsWhichScriptsAssignToFields) {
    std::string const before =
        "return interaction { store = { object = { n = 0 } }, apply = function(object, params, out, store) ";
    for (std::string const assigns :
         {"object.x = 1", "object['x'] = 1", "local a a, object.x = 1, 2", "object.x, a = 1, 2",
          "function object.f() end", "local store = object store.object.x = 1",
          "for store in f do store.object.x = 1 end", "local f = function(store) store.object.x = 1 end",
          "local a, store store.object.x = 1", "local t = { f = function() object.x = 1 end }",
          "local function store() end store.object.x = 1", "x.store.object.n = 1"}) {
        EXPECT_TRUE(counted(before + assigns + " end }").assignsFields) << assigns;
    }
    for (std::string const harmless :
         {"local x = object.y", "store.object.n = store.object.n + 1",
          "store.object.n, store.script.m = 1, 2", "local t = { x = 1, ['y'] = 2, object.z }",
          "if object.x == 1 then out.f(object, { x = 1 }) end", "local a, b = object.x, 2",
          "for i = 1, object.x do end"}) {
        EXPECT_FALSE(counted(before + harmless + " end }").assignsFields) << harmless;
    }
    EXPECT_EQ(counted("local a = 1 a = 2 b = 3 c, d = 4, 5 function e() end").assigned,
              (std::set<std::string, std::less<>>{"a", "b", "c", "d", "e"}));
}

TEST(CountedSource, RefusesBlocksThatDoNotMatch) {
    for (std::string const bad : {"end while true do end return function()", "do", "for i = 1, 2 end", "f(",
                                  "}", "until x", "repeat end", "local __count = 1e300", "return __over"}) {
        std::optional<BlockFault> fault;
        (void)countSource(bad, fault);
        EXPECT_TRUE(fault) << bad;
    }
}

TEST(CountedSource, KeepsTheLines) {
    Sandbox sandbox({});
    ASSERT_FALSE(sandbox.load("\n\nlocal function f()\n  for i = 1, 2 do\n    error('here')\n  end\nend\nf()",
                              "lines.lua"));
    auto const failed = sandbox.turn(1, [&](lua_State* L) {
        sandbox.pushChunk(L);
        sandbox.callScript(L, 0, 0);
    });
    ASSERT_TRUE(failed);
    EXPECT_EQ(failed->message, "lines.lua:5: here");
}

// By hand: half of a body's tokens, for each time that it runs.
TEST(CountedSource, CountsABodyAsOftenAsItIsRun) {
    double const once = instructionsOf("local n = 0 for i = 1, 1 do n = n + i end");
    for (int const times : {2, 10, 100}) {
        double const many = instructionsOf(fmt::format("local n = 0 for i = 1, {} do n = n + i end", times));
        EXPECT_DOUBLE_EQ((many - once) / (times - 1), 6) << "12 tokens, from 'i' to 'end'";
    }
    EXPECT_EQ(instructionsOf("local n = 0 for i = 1, 1e9 do n = n + i end"), -1);
}

// Texts of random statements: compiling does not change the count.
TEST(CountedSource, CountsTheSameWhetherCompiledOrNot) {
    std::mt19937 random(7);
    std::function<std::string(int)> const statements = [&](int depth) {
        std::string text;
        for (unsigned i = 0; i < 1 + random() % 3; ++i) {
            switch (depth == 0 ? 0 : random() % 6) {
            case 0:
                text += fmt::format(" n = (n * {} + {}) % 1009", 3 + random() % 50, random() % 100);
                break;
            case 1:
                text += fmt::format(" for i = 1, {} do{} end", random() % 20, statements(depth - 1));
                break;
            case 2:
                text += fmt::format(" do local k = 0 repeat k = k + 1{} until k > n % {} end",
                                    statements(depth - 1), 1 + random() % 5);
                break;
            case 3:
                text += fmt::format(" do local k = {} while k > 0 do k = k - 1{} end end", random() % 10,
                                    statements(depth - 1));
                break;
            case 4:
                text += fmt::format(" if n % 2 == 0 then{} else{} end", statements(depth - 1),
                                    statements(depth - 1));
                break;
            default:
                text += fmt::format(" (function(...) {} end)(n)", statements(depth - 1));
                break;
            }
            text += ";";
        }
        return text;
    };
    for (int i = 0; i < 100; ++i) {
        std::string const text = "local n = 1" + statements(4);
        EXPECT_EQ(instructionsOf(text, Trust::trusted), instructionsOf(text, Trust::untrusted)) << text;
    }
}

} // namespace
} // namespace trembler::lua
