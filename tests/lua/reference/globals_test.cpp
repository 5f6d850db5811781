#include "lua/reference/globals.hpp"
#include "lua/sandbox/sandbox.hpp"
#include "lua/sandbox/stack_values.hpp"

#include <gtest/gtest.h>

#include <lua.hpp>
#include <set>
#include <string>

namespace trembler::lua {
namespace {

// "math.clamp", "vec2": all that a script can name, from the sandbox itself.
std::set<std::string> namesOf(Sandbox& sandbox) {
    std::set<std::string> names;
    auto const failed = sandbox.protect([&](lua_State* L) {
        sandbox.pushSurroundings(L);
        for (std::string const& key : stringKeys(L, -1)) {
            if (static_cast<unsigned char>(key.front()) >= 0x80) {
                continue; // no script can write it
            }
            lua_getfield(L, -1, key.c_str());
            if (lua_istable(L, -1)) { // a library, behind a read-only table
                lua_getmetatable(L, -1);
                // Its metatable is hidden from scripts, not from the host.
                lua_getfield(L, -1, "__index");
                for (std::string const& member : stringKeys(L, -1)) {
                    names.insert(key + "." + member);
                }
                lua_pop(L, 2);
            } else {
                names.insert(key);
            }
            lua_pop(L, 1);
        }
    });
    EXPECT_FALSE(failed) << failed->message;
    return names;
}

TEST(GlobalNotes, AreOfAllThatTheSandboxHandsOutAndOfNothingElse) {
    Sandbox sandbox{ScriptLimits{}};
    std::set<std::string> noted;
    for (GlobalNote const& note : globalNotes()) {
        EXPECT_FALSE(note.meaning.empty()) << note.name;
        if (note.name.find(':') == std::string_view::npos) {
            EXPECT_TRUE(noted.emplace(note.name).second) << note.name << " is noted twice";
        }
    }
    EXPECT_EQ(namesOf(sandbox), noted);
}

TEST(GlobalNotes, HaveExamplesThatHold) {
    for (GlobalNote const& note : globalNotes()) {
        Sandbox sandbox{ScriptLimits{}};
        sandbox.onLog = [](std::string const&) {};
        auto failed = sandbox.load(note.example, "example.lua");
        if (!failed) {
            failed = sandbox.turn(1, [&](lua_State* L) {
                sandbox.pushChunk(L);
                sandbox.callScript(L, 0, 0);
            });
        }
        EXPECT_FALSE(failed) << note.example << ": " << failed->message;
    }
}

} // namespace
} // namespace trembler::lua
