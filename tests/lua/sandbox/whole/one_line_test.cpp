// What a script logs, and its errors, are one line: no part of it looks like a line of the program's own.
#include "lua/sandbox/sandbox.hpp"

#include <gtest/gtest.h>

namespace trembler::lua {
namespace {

TEST(OneLine, IsEveryLogAndEveryError) {
    for (Trust const trust : {Trust::untrusted, Trust::trusted}) {
        Sandbox sandbox(ScriptLimits{}, trust);
        ASSERT_FALSE(sandbox.load("log('a\\nforged', '\\n') error('b\\nc')", "a.lua"));
        std::string said;
        sandbox.onLog = [&](std::string const& line) { said += line; };
        auto const failed = sandbox.turn(1, [&](lua_State* L) {
            sandbox.pushChunk(L);
            sandbox.callScript(L, 0, 0);
        });
        EXPECT_EQ(said, "a<U+000A>forged <U+000A>");
        ASSERT_TRUE(failed);
        EXPECT_EQ(failed->message, "a.lua:1: b<U+000A>c");
    }
}

} // namespace
} // namespace trembler::lua
