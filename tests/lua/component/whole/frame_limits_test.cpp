// Limits hold for a frame: for all turns that a script has in it, one in each part.
#include "runtime/frame/settings.hpp"
#include "tests/lua/support/script_world.hpp"

#include <set>

namespace trembler::lua {
namespace {

std::string limitedScript(std::string const& limits, std::string const& body,
                          std::string const& application = "once = true") {
    return "return interaction { name = \"Dynamics <- Test\", calls = \"Dynamics\", reads = { \"Mass\" },\n" +
           application + ", restless = true, store = { script = { turns = 0 } }, limits = { " + limits +
           " },\napply = function(object, params, out, store)\n"
           "  store.script.turns = store.script.turns + 1\n  " +
           body + "\nend }";
}

/// A world of boxes whose frames have that many parts.
struct PartedWorld {
    PartedWorld(std::string const& source, int parts, Trust trust, int boxes = 1)
        : game({source}, trust), world(game.registry) {
        Store& store = world.store();
        store.column<FrameSettings>().set(store.create("world"), {parts});
        for (int i = 0; i < boxes; ++i) {
            (void)addBox(store, "box " + std::to_string(i), {3.0 * i, 0});
        }
        world.start();
    }
    std::string after(int frames) {
        for (int i = 0; i < frames; ++i) {
            world.step();
        }
        return game.messages();
    }
    ScriptedGame game;
    World world;
};

struct FrameLimit {
    char const* limits;
    char const* body;
    char const* message;
};
// Each turn takes a third of the limit, so the fourth one of a frame goes beyond it.
std::vector<FrameLimit> const& frameLimits() {
    static std::vector<FrameLimit> const all{
        {"instructions = 3000, instructions_per_object = 0", "for i = 1, 120 do local x = i * i end",
         "the script takes more than its 3000 instructions in a frame"},
        {"calls = 6, calls_per_object = 0", "for i = 1, 2 do pcall(out.addForce) end",
         "the script makes more than its 6 calls in a frame"},
    };
    return all;
}

TEST(FrameLimits, AreOfAllTurnsOfAFrameTogether) {
    for (Trust const trust : {Trust::untrusted, Trust::trusted}) {
        for (FrameLimit const& one : frameLimits()) {
            SCOPED_TRACE(one.message);
            std::string const source = limitedScript(one.limits, one.body);
            for (int const parts : {1, 2}) {
                EXPECT_EQ(PartedWorld(source, parts, trust).after(20), "") << parts << " parts";
            }
            for (int const parts : {4, 8}) {
                std::string const said = PartedWorld(source, parts, trust).after(20);
                EXPECT_NE(said.find(one.message), std::string::npos) << parts << " parts: " << said;
            }
        }
    }
}

// The script is stopped in the fourth turn of the first frame with four parts, and not in a later one.
TEST(FrameLimits, StopATurnAndNotALaterFrame) {
    std::string const source =
        limitedScript("instructions = 3000, instructions_per_object = 0",
                      "log(store.script.turns)\n  for i = 1, 120 do local x = i * i end");
    std::string const said = PartedWorld(source, 8, Trust::untrusted).after(3);
    EXPECT_EQ(said.substr(0, 8), "1\n2\n3\n4\n") << said;
    EXPECT_EQ(said.find("\n5\n"), std::string::npos) << said;
}

// Limits per object are added in each turn: 2 calls for each of 20 boxes, with a limit of 2.
TEST(FrameLimits, PerObjectAreOfEachTurn) {
    std::string const source =
        limitedScript("instructions = 1000, instructions_per_object = 100, calls = 0, calls_per_object = 2",
                      "out.addForce(object, vec2(0, 1))\n  out.tellRate(object, 1)", "each = { \"Mass\" }");
    for (Trust const trust : {Trust::untrusted, Trust::trusted}) {
        for (int const parts : {1, 8}) {
            EXPECT_EQ(PartedWorld(source, parts, trust, 20).after(5), "") << parts << " parts";
        }
        std::string const said =
            PartedWorld(limitedScript("calls = 0, calls_per_object = 1",
                                      "out.addForce(object, vec2(0, 1))\n  out.tellRate(object, 1)",
                                      "each = { \"Mass\" }"),
                        1, trust, 20)
                .after(5);
        EXPECT_NE(said.find("more than its 20 calls in a frame"), std::string::npos) << said;
    }
}

TEST(FrameLimits, LogLinesAreOfAFrame) {
    std::string const source = limitedScript("log_lines = 3", "log(store.script.turns)");
    std::string const note = "... further lines of this frame are left out; 'log_lines' in limits is 3\n";
    EXPECT_EQ(PartedWorld(source, 8, Trust::untrusted).after(2), "1\n2\n3\n" + note + "9\n10\n11\n" + note);
    // Exactly as many lines as the limit: nothing is left out, and nothing is said.
    EXPECT_EQ(PartedWorld(source, 2, Trust::untrusted).after(1), "1\n2\n");
    EXPECT_EQ(
        PartedWorld(limitedScript("log_lines = 2", "log(store.script.turns)"), 2, Trust::untrusted).after(1),
        "1\n2\n");
}

// About half of the memory that a frame may allocate, in each turn.
TEST(FrameLimits, AllocatedMemoryIsOfAFrame) {
    std::string const source = limitedScript("instructions = 200000, instructions_per_object = 2000",
                                             "for i = 1, 300 do local t = { i } end", "each = { \"Mass\" }");
    EXPECT_EQ(PartedWorld(source, 1, Trust::untrusted, 100).after(5), "");
    std::string const said = PartedWorld(source, 8, Trust::untrusted, 100).after(5);
    EXPECT_NE(said.find("needs more memory than its limits"), std::string::npos) << said;
}

TEST(FrameLimits, StopAtTheSameTurnInEveryRunAndOnAnyNumberOfThreads) {
    std::string const source = limitedScript("instructions = 3000, instructions_per_object = 0",
                                             "log(store.script.turns)\n  local n = 10 * store.script.turns\n"
                                             "  for i = 1, n do local x = i * i end");
    std::set<std::string> seen;
    for (int const threads : {1, 2, 8, 32, 1}) {
        ScriptedGame game({source});
        WorldOptions options;
        options.threads = threads;
        options.rowsWorthThreads = 0;
        World world(game.registry, options);
        Store& store = world.store();
        store.column<FrameSettings>().set(store.create("world"), {4});
        (void)addBox(store, "box", {0, 0});
        world.start();
        for (int i = 0; i < 40; ++i) {
            world.step();
        }
        seen.insert(game.messages() + std::to_string(world.stateHash()));
    }
    EXPECT_EQ(seen.size(), 1U);
    EXPECT_NE(seen.begin()->find("in a frame"), std::string::npos) << *seen.begin();
}

} // namespace
} // namespace trembler::lua
