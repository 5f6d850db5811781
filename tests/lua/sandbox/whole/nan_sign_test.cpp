// No text that a script can get shows the sign of a number that is none: it differs between interpreted and
// compiled code.
#include "lua/sandbox/prelude/signatures.hpp"
#include "lua/sandbox/sandbox.hpp"

#include <gtest/gtest.h>

#include <string>

namespace trembler::lua {
namespace {

/// Logs every expression whose text differs between the two signs.
std::string differencesOf(std::string const& checks) {
    ScriptLimits limits = ScriptLimits::greatest();
    Sandbox sandbox(limits);
    std::string said;
    sandbox.onLog = [&](std::string const& line) { said += line + "\n"; };
    auto failed = sandbox.load("local zero = 0 local plus = zero / zero local minus = -plus\n"
                               "local function check(name, f)\n"
                               "  local _, a = pcall(f, plus) local _, b = pcall(f, minus)\n"
                               "  if tostring(a) ~= tostring(b) then log(name, a, b) end\n"
                               "end\n" +
                                   checks,
                               "sign.lua");
    if (!failed) {
        failed = sandbox.turn(1, [&](lua_State* L) {
            sandbox.pushChunk(L);
            sandbox.callScript(L, 0, 0);
        });
    }
    return said + (failed ? failed->message : std::string());
}

TEST(NanSign, IsInNoMessageOfAFunction) {
    for (HostFunction const& function : hostFunctions()) {
        if (function.name == "alive" || function.name == "same" || function.name == "frame.random" ||
            function.name == "coroutine.yield" || function.name == "log" || function.name == "print") {
            continue; // there only in a world, outside of pcall(), or written to the log
        }
        std::string name(function.name);
        if (name.starts_with("vec2:")) {
            name = "vec2(1, 2)." + name.substr(5);
        }
        std::string checks;
        for (char const* const before :
             {"", "1, ", "'a', ", "{ 1 }, ", "vec2(1, 2), ", "'a', 1, ", "1, 2, "}) {
            checks += "check([=[" + name + "(" + before + "x)]=], function(x) return " + name + "(" + before +
                      "x) end)\n";
        }
        EXPECT_EQ(differencesOf(checks), "");
    }
}

TEST(NanSign, IsInNoMessageOfAKeyAndNoForm) {
    std::string checks;
    for (char const* const value :
         {"vec2(1, 2)[x]", "math[x]", "string[x]", "log[x]", "({})[x]", "x .. 'a'", "-x .. 'a'",
          "vec2(x, -x)", "('a')[x]", "x < {}", "x + {}", "x()", "x.y", "setmetatable({}, x)"}) {
        checks += std::string("check([=[") + value + "]=], function(x) return tostring(" + value + ") end)\n";
    }
    for (char const* const form : {"%f", "%e", "%E", "%g", "%G", "%a", "%A", "%+f", "% g", "%05.1f", "%-9g",
                                   "%s", "%q", "%d", "%x", "%c"}) {
        checks +=
            std::string("check('") + form + "', function(x) return string.format('" + form + "', x) end)\n";
    }
    for (char const* const statement : {"local v = vec2(1, 2) v[x] = 1", "math[x] = 1",
                                        "local t = {} t[x] = 1", "local v = vec2(1, 2) v.x = x[1]"}) {
        checks += std::string("check([=[") + statement + "]=], function(x) " + statement + " end)\n";
    }
    EXPECT_EQ(differencesOf(checks), "");
}

} // namespace
} // namespace trembler::lua
