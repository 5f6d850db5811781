#include "lua/sandbox/limits.hpp"
#include "lua/sandbox/number_text.hpp"
#include "lua/sandbox/sandbox.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <lua.hpp>
#include <memory>
#include <random>

namespace trembler::lua {
namespace {

/// Whether LuaJIT itself takes a text for a number.
bool isNumberToLua(std::string const& text) {
    static std::unique_ptr<lua_State, void (*)(lua_State*)> const state(luaL_newstate(), lua_close);
    lua_pushlstring(state.get(), text.data(), text.size());
    bool const is = lua_isnumber(state.get(), -1) != 0;
    lua_pop(state.get(), 1);
    return is;
}

TEST(NumberText, IsRecognisedWheneverLuaWouldConvertItSlowly) {
    std::mt19937_64 random(7);
    std::string const alphabet = "0123456789000111....eeE++--xXpPabf \t\n";
    int numbers = 0;
    for (int i = 0; i < 200'000; ++i) {
        std::string text(1 + random() % 40, ' ');
        std::size_t const letters =
            i % 2 == 0 ? alphabet.size() : 16; // half of them of digits and points mostly
        for (char& c : text) {
            c = alphabet[random() % letters];
        }
        if (i % 3 == 0) {
            text += "e" + std::to_string(random() % 400);
        }
        if (!isNumberToLua(text)) {
            continue;
        }
        ++numbers;
        bool const hex = text.find_first_of("xX") != std::string::npos;
        bool const exponent = text.find_first_of(hex ? "pP" : "eE") != std::string::npos;
        EXPECT_EQ(readsAsLongNumber(text), exponent || text.size() > longestNumber) << text;
    }
    EXPECT_GT(numbers, 10'000);
}

TEST(NumberText, LeavesOtherTextsAlone) {
    for (char const* const text :
         {"", " ", "12", "-3.5", "0xff", "lamp 1", "bed1", "1e", "2 boxes", "e5", "..", "+", "inf",
          "12345678901234567890 is long", "1.2.3 and a long rest of the version"}) {
        EXPECT_FALSE(readsAsLongNumber(text)) << text;
    }
}

std::string resultOf(std::string const& expression) {
    Sandbox sandbox{ScriptLimits{}};
    std::string said;
    sandbox.onLog = [&](std::string const& line) { said = line; };
    auto failed = sandbox.load("log(" + expression + ")", "test.lua");
    if (!failed) {
        failed = sandbox.turn(1, [&](lua_State* L) {
            sandbox.pushChunk(L);
            sandbox.callScript(L, 0, 0);
        });
    }
    return failed ? failed->message : said;
}

TEST(CountedJoins, JoinLikeLua) {
    EXPECT_EQ(resultOf("'a' .. 'b'"), "ab");
    EXPECT_EQ(resultOf("'a' .. 1 .. 'b' .. 2.5"), "a1b2.5");
    EXPECT_EQ(resultOf("1 .. 2"), "12");
    EXPECT_EQ(resultOf("'a' .. 1 + 2 .. 'b'"), "a3b") << "sums bind more tightly";
    EXPECT_EQ(resultOf("'a' .. 'b' == 'ab'"), "true") << "comparisons less tightly";
    EXPECT_EQ(resultOf("#('a' .. ('b' .. 'c'))"), "3");
    EXPECT_EQ(resultOf("(function(...) return ... .. 'x' end)('y')"), "yx");
    EXPECT_EQ(resultOf("'..' .. [[..]] --[[ 'a' .. 'b' ]]"), "....");
    EXPECT_EQ(resultOf("'a' .. nil"), "test.lua:1: nil cannot be joined to a text; tostring() makes it one");
    EXPECT_EQ(resultOf("'a' .. vec2(1, 2)"),
              "test.lua:1: a vector cannot be joined to a text; tostring() makes it one");
}

TEST(CountedJoins, BracketTextsThatReadAsLongNumbers) {
    EXPECT_EQ(resultOf("'1' .. 'e' .. '5'"), "(1e5)");
    EXPECT_EQ(resultOf("tostring(1e300)"), "(1e+300)");
    EXPECT_EQ(resultOf("'x = ' .. 1e300"), "x = 1e+300");
    EXPECT_EQ(resultOf("('9'):rep(25)"), "(" + std::string(25, '9') + ")");
    EXPECT_EQ(resultOf("('9'):rep(24)"), std::string(24, '9'));
}

TEST(CountedJoins, KeepLines) {
    std::string const text = "local a = 'x'\n  .. 'y' -- ..\nerror('here')";
    std::string const made = withCountedJoins(text);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), std::count(made.begin(), made.end(), '\n'));
    EXPECT_EQ(resultOf("1)\n\nlocal a = 'x' ..\n'y'\nerror('here'"), "test.lua:5: here");
}

} // namespace
} // namespace trembler::lua
