#include "lua/attach/live_script.hpp"
#include "tests/lua/support/script_world.hpp"

namespace trembler::lua {
namespace {

std::string pushing(double force, std::string const& more = "reads = { \"Mass\" }, each = { \"Mass\" },") {
    return "return interaction { name = \"Dynamics <- Test\", calls = \"Dynamics\", " + more +
           "\nparams = { force = { default = " + std::to_string(force) +
           ", min = 0, max = 9000 } },\napply = function(object, params, out) out.addForce(object, "
           "vec2(params.force, 0)) "
           "end }";
}

/// A game whose registry can be reached.
struct LiveGame {
    explicit LiveGame(std::string const& source) {
        registerEffects(registry);
        mods.emplace_back();
        mods.back().name = "test";
        Problems problems;
        mods.back().interactions.push_back(readManifest(source, "script.lua", problems));
        scripts = registerMods(registry, mods, log, problems);
        problems.throwIfAny();
    }
    LiveScript& script() const { return *scripts->all().front(); }
    std::shared_ptr<Script const> read(std::string const& text) const {
        Problems problems;
        auto made = scripts->read(script(), text, problems);
        problems.throwIfAny();
        return made;
    }
    Registry registry;
    std::vector<Mod> mods;
    std::shared_ptr<ScriptLog> log = std::make_shared<ScriptLog>();
    std::shared_ptr<LiveScripts const> scripts;
};

/// A world with a box of 1000 kg.
struct LiveWorld {
    explicit LiveWorld(LiveGame const& game)
        : world(game.registry), box(addBox(world.store(), "box", {0, 0})) {
        world.start();
    }
    void steps(int count) {
        for (int i = 0; i < count; ++i) {
            world.step();
        }
    }
    double speed() const { return world.find<Velocity>(box)->value.x; }
    World world;
    ObjectId box;
};

// Box2D computes in floats: at 2 m/s each of some 120 additions rounds by up to 1.2e-7 m/s.
constexpr double rounding = 5e-5;

TEST(LiveScript, AnotherVersionIsForNewWorldsUntilItIsSwappedIn) {
    LiveGame const game(pushing(1000));
    LiveWorld first(game);
    first.steps(61);
    game.script().publish(game.read(pushing(3000)));
    LiveWorld second(game);
    second.steps(61);
    EXPECT_NEAR(second.speed(), 3, rounding);
    first.steps(60);
    EXPECT_NEAR(first.speed(), 2, rounding);
    EXPECT_TRUE(game.script().swapIn());
    first.steps(61);
    EXPECT_NEAR(first.speed(), 2 + 1.0 / 60 + 3, 2 * rounding)
        << "one frame with the force of the old version";
}

TEST(LiveScript, NoWorldNothingToSwap) {
    LiveGame const game(pushing(1000));
    EXPECT_FALSE(game.script().swapIn());
    EXPECT_FALSE(game.script().usage());
    EXPECT_FALSE(game.script().failed());
    { LiveWorld const gone(game); }
    EXPECT_FALSE(game.script().swapIn());
}

TEST(LiveScript, AVersionThatDoesTheSameChangesNoHash) {
    LiveGame const game(pushing(1000));
    LiveWorld changes(game);
    game.script().publish(game.read(pushing(1000) + " -- the same"));
    changes.steps(30);
    EXPECT_TRUE(game.script().swapIn());
    changes.steps(30);
    LiveWorld never(game);
    never.steps(60);
    EXPECT_EQ(never.world.stateHash(), changes.world.stateHash());
}

TEST(LiveScript, ADescriptionThatChangedActivatesTheScriptInNewWorlds) {
    LiveGame const game(pushing(1000, "reads = { \"Mass\", \"Liquid\" }, each = { \"Mass\", \"Liquid\" },"));
    LiveWorld dry(game);
    dry.steps(2);
    EXPECT_EQ(statusOf(dry.world, "Dynamics <- Test").activity, Activity::absent);
    game.script().publish(game.read(pushing(1000)));
    LiveWorld world(game);
    world.steps(61);
    EXPECT_NEAR(world.speed(), 1, 1e-5);
    dry.steps(2);
    EXPECT_EQ(statusOf(dry.world, "Dynamics <- Test").info->text.name, "Dynamics <- Test");
}

TEST(LiveScript, RestsAndGoesOnInEveryWorld) {
    LiveGame const game(pushing(1000));
    LiveWorld world(game);
    world.steps(61);
    game.script().setOn(false);
    LiveWorld later(game);
    world.steps(30);
    later.steps(30);
    EXPECT_NEAR(world.speed(), 1, 1e-5);
    EXPECT_EQ(later.speed(), 0);
    game.script().setOn(true);
    later.steps(61);
    EXPECT_NEAR(later.speed(), 1, 1e-5);
}

TEST(LiveScripts, OtherDefaultsThatFitCount) {
    LiveGame const game(pushing(1000));
    auto const made = game.scripts->with(game.script().script(), {{"force", 2000.0}, {"none", 1.0}});
    EXPECT_EQ(made->manifest.parameter("force")->initial, Value(2000.0));
    auto const unfit = game.scripts->with(game.script().script(), {{"force", 1e6}});
    EXPECT_EQ(unfit->manifest.parameter("force")->initial, Value(1000.0));
}

} // namespace
} // namespace trembler::lua
