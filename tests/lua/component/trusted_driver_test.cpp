// Trusted scripts are compiled and read columns by FFI. Their results are those of untrusted scripts, to the
// bit.
#include "tests/lua/support/script_world.hpp"

#include <cmath>

namespace trembler::lua {
namespace {

std::string trustTestScript(std::string const& body, std::string const& more = "each = { \"Mass\" },",
                            std::string const& parameters = "object, params, out, store, frame") {
    return "local factor = 1.5\nreturn interaction {\n  name = \"Dynamics <- Test\", calls = \"Dynamics\",\n"
           "  reads = { \"Position\", \"Velocity\", \"Mass\", \"Rotation\", \"Density\", \"Gravity\" },\n"
           "  restless = true, " +
           more + "\n  apply = function(" + parameters + ")\n" + body + "\n  end,\n}\n";
}

/// A world of boxes, some with a density of their own, after that many frames: its hash, and the messages of
/// its script.
struct TrustedRun {
    std::uint64_t hash = 0;
    std::string said;
    double moved = 0; // m, of the last box
};
TrustedRun runWith(std::string const& source, Trust trust, int threads, int frames, bool trace = false) {
    ScriptedGame game({source}, trust);
    WorldOptions options;
    options.threads = threads;
    options.rowsWorthThreads = 0;
    options.trace = trace;
    World world(game.registry, options);
    ObjectId last;
    for (int i = 0; i < 60; ++i) {
        last = addBox(world.store(), "box " + std::to_string(i), {3.0 * i, 0.1 * i}, {0.01 * i, -0.2});
        world.store().column<Mass>().set(last, {500 + 10.0 * i});
        if (i % 3 == 0) {
            world.store().column<Density>().set(last, {400 + 5.0 * i});
        }
    }
    world.start();
    for (int i = 0; i < frames; ++i) {
        world.step();
    }
    return {world.stateHash(), game.messages(), world.find<Position>(last)->value.x};
}

struct TrustCase {
    char const* name;
    std::string source;
};
std::vector<TrustCase> const& trustCases() {
    static std::vector<TrustCase> const cases{
        {"numbers",
         trustTestScript("out.addForce(object, object.Mass.value * (10 - object.Velocity.value.x), "
                         "-object.Position.value.y)")},
        {"vectors",
         trustTestScript("local p = object.Position.value\n"
                         "out.addForce(object, (vec2(3, 1) - p:unit() * factor) * object.Mass.value)")},
        {"optional property", trustTestScript("if object.Density then\n"
                                              "out.addForce(object, object.Density.value, 0)\nelse\n"
                                              "out.addTorque(object, object.Mass.value)\nend")},
        {"state and chance",
         trustTestScript("store.object.sum = store.object.sum + frame.random() - object.Velocity.value.y\n"
                         "store.script.count = (store.script.count + 1) % 7\n"
                         "out.addForce(object, 100 * store.object.sum, store.script.count - 3)",
                         "each = { \"Mass\" }, store = { object = { sum = 0 }, script = { count = 0 } },")},
        {"fields of a table of its own",
         trustTestScript("local t = { 1, 2 }\nfor i = 3, 9 do t[i] = t[i - 1] % 5 + t[i - 2] end\n"
                         "out.addForce(object, t[9] * object.Position.value)")},
        {"mathematics",
         trustTestScript(
             "local a = object.Position.value.x * 0.37 - 5\n"
             "local f = math.sin(a) * math.exp(-a * a / 100) + math.floor(a) % 3 + math.fmod(a, 0.7)\n"
             "f = f + math.sqrt(math.abs(a)) + math.atan2(a, 2) + math.ceil(-a / 3) / 7\n"
             "out.addForce(object, vec2(f, -f):turned(a) * 50)")},
        {"arguments by name, and default ones",
         trustTestScript("out.addForce{ object = object, force = vec2(object.Mass.value, 1) }\n"
                         "out.tellRate(object, 3)")},
        {"pairs", trustTestScript("local apart = b.Position.value - a.Position.value\n"
                                  "out.addForce(a, apart * 10)\nout.addForce(b, apart * -10)",
                                  "pairs = { first = { \"Mass\" }, second = { \"Mass\" }, within = 7 },",
                                  "a, b, params, out")},
        {"errors that are caught",
         trustTestScript("local ok = pcall(function() return object.Velocity.speed end)\n"
                         "local fine, why = pcall(out.addForce, object, 'much')\n"
                         "out.addForce(object, ok and 1 or 2, #why)")},
        {"an error", trustTestScript("out.addForce(object, 100, 0)\n"
                                     "if object.Velocity.value.x > 0.7 then error('enough') end")},
        {"too many instructions",
         trustTestScript("local n = object.Velocity.value.x > 0.65 and 1e9 or 10\nlocal sum = 0\n"
                         "for i = 1, n do sum = sum + i end\nout.addForce(object, sum, 0)")},
        {"too many calls", trustTestScript("local n = object.Velocity.value.x > 0.65 and 1e5 or 2\n"
                                           "for i = 1, n do out.addForce(object, 30, 0) end")},
    };
    return cases;
}

TEST(TrustedDriver, HasTheHashOfTheInterpreterOnAnyNumberOfThreads) {
    for (TrustCase const& one : trustCases()) {
        TrustedRun const untrusted = runWith(one.source, Trust::untrusted, 1, 90);
        EXPECT_NE(untrusted.moved, 3.0 * 59) << one.name << ": nothing has happened";
        for (int const threads : {1, 2, 8, 32}) {
            TrustedRun const trusted = runWith(one.source, Trust::trusted, threads, 90);
            EXPECT_EQ(trusted.hash, untrusted.hash) << one.name << ", " << threads << " threads";
            EXPECT_EQ(trusted.said, untrusted.said) << one.name;
        }
    }
}

TEST(TrustedDriver, HasThatHashOverManyFrames) {
    std::string const& source = trustCases().front().source;
    EXPECT_EQ(runWith(source, Trust::trusted, 2, 1500).hash, runWith(source, Trust::untrusted, 1, 1500).hash);
}

TEST(TrustedDriver, RecordsTracedCallsOneByOne) {
    std::string const& source = trustCases()[2].source;
    EXPECT_EQ(runWith(source, Trust::trusted, 1, 60, true).hash,
              runWith(source, Trust::untrusted, 1, 60, false).hash);
}

// The force of each box is known: F = m a, from rest, in one frame.
TEST(TrustedDriver, ReadsWhatTheColumnsHold) {
    ScriptedGame game(
        {trustTestScript("out.addForce(object, object.Mass.value * object.Position.value.x, 0)")},
        Trust::trusted);
    World world(game.registry);
    std::vector<ObjectId> boxes;
    for (int i = 0; i < 300; ++i) {
        boxes.push_back(addBox(world.store(), "box " + std::to_string(i), {2.0 * i, 0}));
    }
    world.start();
    world.step();
    world.step(); // the calls of the first frame are carried out
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        double const expected = 2.0 * static_cast<double>(i) / 60;
        EXPECT_NEAR(world.find<Velocity>(boxes[i])->value.x, expected, 1e-5 * (1 + expected));
    }
    EXPECT_EQ(game.messages(), "");
}

TEST(TrustedDriver, FollowsObjectsThatComeAndGo) {
    std::string const source = trustTestScript("if object.Density then out.addForce(object, 600, 0) end");
    std::vector<std::uint64_t> hashes;
    for (Trust const trust : {Trust::untrusted, Trust::trusted}) {
        ScriptedGame game({source}, trust);
        World world(game.registry);
        std::vector<ObjectId> boxes;
        for (int i = 0; i < 80; ++i) {
            boxes.push_back(addBox(world.store(), "box " + std::to_string(i), {2.0 * i, 0}));
        }
        world.start();
        for (std::size_t frame = 0; frame < 70; ++frame) {
            world.store().column<Density>().set(boxes[frame], {500});
            if (frame >= 5) {
                world.store().column<Density>().remove(boxes[frame - 5]);
            }
            world.step();
        }
        EXPECT_EQ(game.messages(), "");
        EXPECT_GT(world.find<Velocity>(boxes[20])->value.x, 0.01);
        hashes.push_back(world.stateHash());
    }
    EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(TrustedDriver, WritesNoPropertyAndReachesNothing) {
    for (std::string const body :
         {"object.Velocity.value = vec2(9, 9)", "object.Velocity.value.x = 9", "object.Velocity = nil",
          "local v = object.Velocity v.value = 3", "local o = { object } o[1].Mass.value = 3",
          "local store = object.Velocity store.value = 3", "out.addForce = nil", "frame.duration = 3",
          "local f = ffi", "local j = jit", "local d = debug", "setmetatable(object, {})",
          "getmetatable(object).__index = 3", "math.sin = 3", "table.insert(object, 3)"}) {
        for (Trust const trust : {Trust::untrusted, Trust::trusted}) {
            ScriptedGame game({trustTestScript(body)}, trust);
            World world(game.registry);
            ObjectId const box = addBox(world.store(), "box", {0, 0}, {1, 0});
            world.start();
            for (int i = 0; i < 5; ++i) {
                world.step();
            }
            EXPECT_FALSE(game.messages().empty()) << body;
            EXPECT_EQ(world.find<Velocity>(box)->value.x, 1.0) << body;
            EXPECT_EQ(world.find<Mass>(box)->value, 1000.0) << body;
        }
    }
}

} // namespace
} // namespace trembler::lua
