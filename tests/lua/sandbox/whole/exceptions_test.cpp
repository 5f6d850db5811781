// An exception of the host goes past the script, which cannot catch it, to whoever runs the turn.
#include "lua/sandbox/sandbox.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace trembler::lua {
namespace {

TEST(Exceptions, OfTheHostAreNoErrorsOfAScript) {
    for (Trust const trust : {Trust::untrusted, Trust::trusted}) {
        for (std::string const call :
             {"pcall(log, 'bad')", "xpcall(function() log('bad') end, function(e) log(e) return e end)",
              "coroutine.resume(coroutine.create(function() log('bad') end))",
              "pcall(coroutine.wrap(function() pcall(log, 'bad') log('inside') end))", "log('bad')"}) {
            SCOPED_TRACE(call);
            Sandbox sandbox(ScriptLimits{}, trust);
            ASSERT_FALSE(sandbox.load("log('first') local good, message = " + call + " log('later', message)",
                                      "a.lua"));
            std::vector<std::string> lines;
            bool fails = true;
            sandbox.onLog = [&](std::string const& line) {
                lines.push_back(line);
                if (fails && line == "bad") {
                    throw std::length_error("no room");
                }
            };
            auto const turn = [&] {
                return sandbox.turn(1, [&](lua_State* L) {
                    sandbox.pushChunk(L);
                    sandbox.callScript(L, 0, 0);
                });
            };
            EXPECT_THROW((void)turn(), std::length_error);
            EXPECT_EQ(lines, (std::vector<std::string>{"first", "bad"}));
            fails = false; // the sandbox is as before
            EXPECT_FALSE(turn());
            EXPECT_GE(lines.size(), 5U);
        }
    }
}

TEST(Exceptions, OfTheHostsOwnCodeAreThrownAgain) {
    Sandbox sandbox{ScriptLimits{}};
    EXPECT_THROW((void)sandbox.protect([](lua_State*) { throw std::out_of_range("there"); }),
                 std::out_of_range);
    EXPECT_FALSE(sandbox.protect([](lua_State*) {}));
}

} // namespace
} // namespace trembler::lua
