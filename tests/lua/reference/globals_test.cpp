#include "lua/reference/globals.hpp"
#include "lua/sandbox/prelude/signatures.hpp"
#include "lua/sandbox/sandbox.hpp"
#include "lua/sandbox/stack_values.hpp"
#include "tests/lua/support/script_world.hpp"

#include <gtest/gtest.h>

#include <algorithm>
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
        if (!note.inApply && note.name.find(':') == std::string_view::npos) {
            EXPECT_TRUE(noted.emplace(note.name).second) << note.name << " is noted twice";
        }
    }
    EXPECT_EQ(namesOf(sandbox), noted);
}

// What a page says of a function's arguments is what the host checks.
TEST(GlobalNotes, StateTheArgumentsThatTheHostChecks) {
    for (HostFunction const& function : hostFunctions()) {
        auto const note = std::find_if(globalNotes().begin(), globalNotes().end(),
                                       [&](GlobalNote const& one) { return one.name == function.name; });
        ASSERT_NE(note, globalNotes().end()) << function.name;
        if (function.name != "interaction") { // written with a table
            EXPECT_EQ(note->use, signatureOf(function));
        }
    }
    for (GlobalNote const& note : globalNotes()) {
        bool const called = note.use.find('(') != std::string_view::npos;
        EXPECT_TRUE(!called || hostFunction(note.name).name == note.name) << note.name;
    }
}

TEST(GlobalNotes, HaveExamplesThatHoldInApply) {
    for (GlobalNote const& note : globalNotes()) {
        if (!note.inApply) {
            continue;
        }
        ScriptedGame const game(
            {"return interaction { name = 'Dynamics <- Test', calls = 'Dynamics', reads = { 'Gravity', "
             "'Mass' }, each = { 'Mass' }, store = { object = { count = 0 }, script = { total = 0 } },\n"
             "apply = function(object, params, out, store, frame)\n" +
             std::string(note.example) + "\nlog('done') end }"});
        World world(game.registry);
        addBox(world.store(), "box", {0, 0});
        world.start();
        world.step();
        EXPECT_EQ(game.messages(), "done\n") << note.example;
    }
}

TEST(GlobalNotes, HaveExamplesThatHold) {
    for (GlobalNote const& note : globalNotes()) {
        if (note.inApply) {
            continue;
        }
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
