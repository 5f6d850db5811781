// The errors of the functions that scripts have are in German for a German player. They stand in Lua, where
// the tests that look for texts in the program do not see them.
#include "lua/sandbox/prelude/prelude.hpp"
#include "lua/sandbox/sandbox.hpp"
#include "puzzle/language/catalogue.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

namespace trembler::lua {
namespace {

std::string errorOf(std::string const& chunk) {
    Sandbox sandbox{ScriptLimits{}};
    auto failed = sandbox.load(chunk, "wrong.lua");
    if (!failed) {
        failed = sandbox.turn(1, [&](lua_State* L) {
            sandbox.pushChunk(L);
            sandbox.callScript(L, 0, 0);
        });
    }
    return failed ? failed->message : std::string();
}

/// For each place of the prelude that raises an error of its own, a script that gets there.
std::set<std::string> const& wrongChunks() {
    static std::set<std::string> const all{
        "local v = vec2(1, 2) v.x = true",
        "undeclared = 1",
        "local x = vec2(1, 2).z",
        "local v = vec2(1, 2) v.z = 1",
        "local x = vec2(1, 2) / vec2(1, 2)",
        "local x = vec2(1, 2) * vec2(1, 2)",
        "local x = vec2(1, 2) + 1",
        "local x = vec2(1, 2) - 1",
        "table.insert({}, 'x', 1)",
        "table.insert({}, 1, nil)",
        "table.insert({}, nil)",
        "table.remove({}, 5)",
        "for i = 1, 51 do coroutine.create(log) end",
        "next({ 1 }, 7)",
        "local function f() pcall(f) error('x') end local function g(n) if n > 45 then return end local "
        "good, m = "
        "pcall(g, n + 1) if not good then error(m, 0) end end g(1)",
        "string.byte(('x'):rep(500), 1, 400)",
        "string.char(unpack({}, 1, 101))",
        "string.char(unpack((function() local t = {} for i = 1, 101 do t[i] = 65 end return t end)()))",
        "string.format('%y', 1)",
        "string.format('%d', 1, 2)",
        "string.format(('x'):rep(501))",
        "string.format('%100d', 1)",
        "string.format('%')",
        "string.format('%d', 'x')",
        "string.format('%q', {})",
        "string.format('%d %d', 1)",
        "string.format('%d', 1e300)",
        "string.format('%c', 256)",
        "string.rep('ab', 1000)",
        "table.concat({ ('x'):rep(600), ('x'):rep(600) })",
        "table.concat({ {} })",
        "table.insert({}, 7, 1)",
        "table.remove({ 1 }, 7)",
        "setmetatable({}, { __concat = log })",
        "setmetatable({}, { __gc = log })",
        "unpack({}, 1, 300)",
        "io.write('x')",
        "local x = nothingLikeIt",
        "local x = math.nothingLikeIt",
        "math.pi = 3",
        "string.len = 3",
        "table.sort = 3",
        "coroutine.wrap = 3",
        "pairs({ [log] = 1 })",
        "math.random()",
        "local x = math.pow(2, 3)",
        "('a'):gsub('a', 'b')",
        "('a.b'):find('.', 1, false)",
        "local x = string.dump",
        "local x = 'a' .. {}",
        "math.abs('x')",
        "math.abs()",
        "math.abs(1, 2)",
        "local t = {} t.x = #true",
    };
    return all;
}

TEST(GermanErrors, OfEveryFunctionThatScriptsHave) {
    Catalogue const german(std::filesystem::path(TREMBLER_SOURCE_DIR) / "assets/text", "de");
    std::set<std::string> messages;
    for (std::string const& chunk : wrongChunks()) {
        std::string const message = errorOf(chunk);
        SCOPED_TRACE(chunk + "\n  " + message);
        ASSERT_TRUE(message.starts_with("wrong.lua:1: "));
        std::string const shown = german.translated(message);
        EXPECT_TRUE(shown.starts_with("wrong.lua:1: "));
        for (char const* const word : {" is ", " the ", "there ", "expected", "makes ", "takes ", "gives "}) {
            EXPECT_EQ(shown.find(word), std::string::npos) << shown;
        }
        messages.insert(message);
    }
    std::string_view const prelude = preludeText();
    std::size_t places = 0;
    for (std::size_t at = prelude.find(" err("); at != std::string_view::npos;
         at = prelude.find(" err(", at + 1)) {
        ++places;
    }
    EXPECT_GE(messages.size(), places) << "an error that no chunk above raises";
}

} // namespace
} // namespace trembler::lua
