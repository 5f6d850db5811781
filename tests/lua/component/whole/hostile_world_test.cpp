// Hostile scripts in a world: each stops its own interaction and nothing else. A level with another script
// continues, bit for bit, as if the hostile one did not exist. No time is measured.
#include "tests/lua/support/hostile_scripts.hpp"
#include "tests/lua/support/script_world.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>

namespace trembler::lua {
namespace {

namespace fs = std::filesystem;

constexpr int frames = 30;
constexpr int repeatedFrames = 10; // for each number of threads

std::string contentOf(fs::path const& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string stated(std::string const& text) {
    std::string const key = "-- expect: ";
    auto const at = text.find(key);
    return at == std::string::npos ? "refused"
                                   : text.substr(at + key.size(), text.find('\n', at) - at - key.size());
}

std::string const witness = R"(return interaction {
  name = "Dynamics <- Witness", calls = "Dynamics", reads = { "Position", "Mass" }, each = { "Mass" },
  restless = true, store = { script = { turns = 0 } },
  apply = function(object, params, out, store, frame)
    store.script.turns = store.script.turns + 1
    local push = math.sin(object.Position.value.x + store.script.turns) + frame.random()
    out.addForce(object, vec2(100 * push, 0))
  end,
})";

std::string hostileInteraction(std::string const& body) {
    return "return interaction { name = \"Dynamics <- Hostile\", calls = \"Dynamics\", restless = true,\n"
           "reads = { \"Position\", \"Velocity\", \"Mass\", \"Shape\", \"contacts\" }, each = { \"Mass\" },\n"
           "params = { speed = { default = 1, min = 0, max = 2 } },\n"
           "store = { script = { count = 0, text = '' } },\n"
           "apply = function(object, params, out, store, frame)\n" +
           body + "\nend }";
}

struct Outcome {
    std::vector<double> course; // of every body, in every frame
    std::vector<std::uint64_t> hashes;
    int errors = 0; // of the hostile script
    int errorsOfOthers = 0;
    int lines = 0;
    std::string said; // the errors of the hostile script
};

Outcome play(ScriptedGame const& game, int threads, int length = frames) {
    (void)game.log->take();
    WorldOptions options;
    options.threads = threads;
    options.rowsWorthThreads = 0;
    World world(game.registry, options);
    Store& store = world.store();
    store.column<GravityField>().set(store.create("world"), {{0, -9.81}});
    ObjectId const floor = addBox(store, "floor", {0, -1});
    store.column<Fixed>().set(floor, {});
    std::vector<ObjectId> const boxes{addBox(store, "a", {0, 0.1}), addBox(store, "b", {0.2, 1.3}),
                                      addBox(store, "c", {5, 3}, {1, 0})};
    world.start();
    Outcome seen;
    for (int frame = 0; frame < length; ++frame) {
        world.step();
        for (ObjectId const box : boxes) {
            Vec2 const at = world.find<Position>(box)->value;
            Vec2 const velocity = world.find<Velocity>(box)->value;
            seen.course.insert(seen.course.end(), {at.x, at.y, velocity.x, velocity.y});
        }
        seen.hashes.push_back(world.stateHash());
    }
    for (ScriptMessage const& message : game.log->take()) {
        bool const hostile = message.script == "Dynamics <- Hostile";
        seen.said += hostile && message.error ? message.text + "\n" : "";
        (message.error ? (hostile ? seen.errors : seen.errorsOfOthers) : seen.lines) += 1;
    }
    return seen;
}

Outcome const& undisturbed() {
    static Outcome const alone = play(ScriptedGame({witness}), 1);
    return alone;
}

class HostileInWorld : public testing::TestWithParam<fs::path> {};

TEST_P(HostileInWorld, RuinsItsOwnInteractionAndNothingElse) {
    std::string const text = contentOf(GetParam());
    std::string const expected = stated(text);
    if (expected == "refused") { // as a whole script: there is a message, and it never runs
        Problems problems;
        (void)readManifest(text, "hostile.lua", problems);
        EXPECT_GE(problems.count(), 1U);
        return;
    }
    ScriptedGame const game({witness, hostileInteraction(text)}); // takes as long as the worlds together
    Outcome const one = play(game, 1);
    EXPECT_EQ(one.course, undisturbed().course) << "the level and the other script go on as they did";
    EXPECT_EQ(one.errorsOfOthers, 0);
    EXPECT_EQ(one.errors, expected == "harmless" ? 0 : 1) << "the player gets one message: " << one.said;
    EXPECT_LE(one.lines, frames * (static_cast<int>(ScriptLimits().logLines) + 1))
        << "the last says that there were more";
    std::vector<std::uint64_t> const beginning(one.hashes.begin(), one.hashes.begin() + repeatedFrames);
    for (int const threads : {1, 2, 8, 32}) {
        Outcome const again = play(game, threads, repeatedFrames);
        EXPECT_EQ(again.hashes, beginning) << threads << " threads";
    }
}

INSTANTIATE_TEST_SUITE_P(Scripts, HostileInWorld, testing::ValuesIn(scriptsBelow(hostileFolder())),
                         [](auto const& info) { return hostileTestName(info.param); });

} // namespace
} // namespace trembler::lua
