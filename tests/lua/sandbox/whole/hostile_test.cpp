// Every script of tests/lua/hostile/chunk, each named after its attack: it is stopped, and the state works as
// before. No time is measured: the test passes if it ends.
#include "lua/sandbox/sandbox.hpp"
#include "lua/sandbox/stack_values.hpp"
#include "tests/lua/support/hostile_scripts.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <lua.hpp>

namespace trembler::lua {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> hostileScripts() {
    return scriptsBelow(hostileFolder() / "chunk");
}

std::string textOf(fs::path const& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string expectedOf(std::string const& text) {
    std::string const key = "-- expect: ";
    auto const at = text.find(key);
    return at == std::string::npos ? "refused"
                                   : text.substr(at + key.size(), text.find('\n', at) - at - key.size());
}

std::optional<ScriptError> turnOf(Sandbox& sandbox, std::size_t objects = 1) {
    return sandbox.turn(objects, [&](lua_State* L) {
        sandbox.pushChunk(L);
        sandbox.callScript(L, 0, 0);
    });
}

// The globals that a script sees in a valid turn, as one line.
std::string surroundings(Sandbox& sandbox) {
    std::string seen;
    sandbox.onLog = [&](std::string const& line) { seen += line + "\n"; };
    auto const failed = sandbox.protect([&](lua_State* L) {
        sandbox.pushSurroundings(L);
        for (std::string const& key : stringKeys(L, -1)) {
            lua_getfield(L, -1, key.c_str());
            seen += key + " " + kindOf(L, -1) + "\n";
            lua_pop(L, 1);
        }
    });
    return failed ? failed->message : seen;
}

class Hostile : public testing::TestWithParam<fs::path> {};

TEST_P(Hostile, IsStoppedAndLeavesNothingBehind) {
    std::string const text = textOf(GetParam());
    std::string const expected = expectedOf(text);
    ScriptLimits const limits;
    Sandbox sandbox(limits);
    std::string const before = surroundings(sandbox);
    if (auto const refused = sandbox.load(text, "hostile.lua")) {
        EXPECT_EQ(expected, "refused") << refused->message;
        return;
    }
    Sandbox other(limits); // has the same turns, and is stopped at the same instructions
    ASSERT_FALSE(other.load(text, "hostile.lua"));
    for (int turn = 0; turn < 3; ++turn) {
        int lines = 0;
        sandbox.onLog = [&](std::string const& line) {
            ++lines;
            EXPECT_LE(line.size(), longestLogLine);
        };
        auto const failed = turnOf(sandbox);
        std::string const got = !failed ? "harmless" : failed->limit ? "limit" : "error";
        EXPECT_EQ(got, expected) << (failed ? failed->message : "");
        EXPECT_LE(sandbox.instructions(), limits.instructions + limits.instructionsPerObject);
        EXPECT_LE(sandbox.memory().used(), limits.memory);
        EXPECT_LE(lines, static_cast<int>(limits.logLines) + 1) << "the last one says that there were more";
        if (failed) {
            EXPECT_FALSE(failed->message.empty());
            EXPECT_LE(failed->message.size(), 1100U);
        }
        auto const again = turnOf(other);
        EXPECT_EQ(again ? again->message : "", failed ? failed->message : "");
        EXPECT_EQ(other.instructions(), sandbox.instructions());
    }
    EXPECT_EQ(surroundings(sandbox), before);
}

INSTANTIATE_TEST_SUITE_P(Scripts, Hostile, testing::ValuesIn(hostileScripts()),
                         [](auto const& info) { return hostileTestName(info.param); });

TEST(HostileScripts, AreMoreThanAHundred) {
    EXPECT_GE(hostileScripts().size(), 100U);
}

} // namespace
} // namespace trembler::lua
