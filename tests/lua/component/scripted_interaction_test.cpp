#include "lua/component/scripted_interaction.hpp"
#include "runtime/notation/notation.hpp"
#include "tests/lua/support/script_world.hpp"

namespace trembler::lua {
namespace {

std::string scriptOf(std::string const& body,
                     std::string const& more = "each = { \"Mass\", \"Velocity\" },") {
    return "return interaction {\n  name = \"Dynamics <- Test\", calls = \"Dynamics\",\n"
           "  reads = { \"Position\", \"Velocity\", \"Mass\", \"Rotation\", \"contacts\", \"Gravity\", "
           "\"Joint\", \"Name\" },\n  " +
           more + "\n  apply = function(object, params, out, store, frame)\n" + body + "\n  end,\n}\n";
}

// Box2D computes in floats: velocities are compared to 1e-5 m/s.
struct Play {
    explicit Play(std::string const& source, WorldOptions const& options = {})
        : game({source}), world(std::make_unique<World>(game.registry, options)) {}
    void steps(int count) {
        for (int i = 0; i < count; ++i) {
            world->step();
        }
    }
    ScriptedGame game;
    std::unique_ptr<World> world;
};

TEST(ScriptedInteraction, AddsAForceLikeAnyOther) {
    Play run(scriptOf("out.addForce(object, vec2(object.Mass.value * 2, 0))"));
    ObjectId const box = addBox(run.world->store(), "box", {0, 0});
    run.world->start();
    run.steps(61); // the call of the first frame is carried out in the second
    EXPECT_EQ(run.game.messages(), "");
    EXPECT_NEAR(run.world->find<Velocity>(box)->value.x, 2.0, 1e-5);
}

TEST(ScriptedInteraction, SleepsWhileNothingThatItReadsChanges) {
    ScriptedGame game(
        {"return interaction { name = \"Dynamics <- Test\", calls = \"Dynamics\", reads = { \"Mass\" },\n"
         "each = { \"Mass\" }, apply = function(object, params, out) out.addForce(object, vec2(1000, 0)) "
         "end }"});
    World world(game.registry);
    ObjectId const box = addBox(world.store(), "box", {0, 0});
    world.start();
    for (int i = 0; i < 61; ++i) {
        world.step();
    }
    ComponentStatus const status = statusOf(world, "Dynamics <- Test");
    EXPECT_EQ(status.updates, 1U);
    EXPECT_EQ(status.activity, Activity::asleep);
    EXPECT_NEAR(world.find<Velocity>(box)->value.x, 1.0, 1e-5) << "its force goes on while it sleeps";
}

TEST(ScriptedInteraction, IsAbsentIfNoObjectActivatesIt) {
    Play run(scriptOf("error('never')"));
    ObjectId const wall = run.world->store().create("wall");
    run.world->store().column<Position>().set(wall, {});
    run.world->start();
    run.steps(3);
    EXPECT_EQ(statusOf(*run.world, "Dynamics <- Test").activity, Activity::absent);
    EXPECT_EQ(run.game.messages(), "");
}

TEST(ScriptedInteraction, StandsInTheNotation) {
    ScriptedGame const game({scriptOf("")});
    std::string const text = notationText(game.registry);
    EXPECT_NE(text.find("(Dynamics <- Test) Interaction"), std::string::npos);
}

TEST(ScriptedInteraction, SaysInWordsWhatIsWrongAndIsSwitchedOffWhileTheWorldGoesOn) {
    struct Case {
        std::string body;
        std::string message;
    };
    std::vector<Case> const cases{
        {"local x = object.Density", "script1.lua:6: the script does not declare that it reads 'Density'"},
        {"local x = object.Velocty", "did you mean 'Velocity'?"},
        {"local x = object.Velocity.speed", "Velocity has no 'speed'; it has 'value'"},
        {"object.Velocity.value = vec2(0, 0)", "'value' cannot be changed"},
        {"object.Velocity = nil", "'Velocity' cannot be changed"},
        {"out.addforce(object, vec2(0, 0))",
         "Dynamics has no function 'addforce' (did you mean 'addForce'?)"},
        {"out.addForce(object)",
         "argument 'force' of addForce is missing; expected addForce(object, force: N)"},
        {"out.addForce(object, 3)",
         "argument 'force' of addForce is a number; expected a vector, vec2(x, y), in N"},
        {"out.addForce(3, vec2(0, 0))", "argument 'object' of addForce is a number; expected an object"},
        {"out.addForce(object, vec2(0/0, 0))", "argument 'force' of addForce is not finite"},
        {"out.addForce(object, vec2(1e300, 0))", "argument 'force' of addForce is 1e+300 N; expected -1e"},
        {"out.addForce(object, vec2(0, 0), 3)", "addForce is given 3 arguments"},
        {"out.tellRate{ object = object, rat = 3 }", "tellRate has no argument 'rat' (did you mean 'rate'?)"},
        {"out.addTorque(object, 'much')",
         "argument 'torque' of addTorque is a string; expected a number, in N m"},
        {"local x = params.speed", "there is no parameter 'speed'"},
        {"store.object.count = 1", "the store declares no 'count'"},
        {"local x = object.contacts", "'contacts' is no property of an object; read it as world.contacts"},
        {"frame.time = 3", "'time' cannot be changed"},
        {"while true do end", "takes more than its"},
        {"for i = 1, 1000 do out.addForce(object, vec2(0, 0)) end", "makes more than its"},
    };
    for (Case const& one : cases) {
        Play run(scriptOf(one.body));
        ObjectId const box = addBox(run.world->store(), "box", {0, 0}, {1, 0});
        run.world->start();
        run.steps(5);
        std::string const said = run.game.messages();
        EXPECT_NE(said.find(one.message), std::string::npos) << one.body << "\n  " << said;
        EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << "once: " << said;
        EXPECT_EQ(run.world->find<Velocity>(box)->value.x, 1.0) << one.body;
        EXPECT_EQ(statusOf(*run.world, "Dynamics <- Test").updates, 1U);
    }
}

TEST(ScriptedInteraction, TakesBackItsCallsWhenItFails) {
    Play run(scriptOf(
        "out.addForce(object, vec2(1000, 0))\n if object.Velocity.value.x > 0.5 then error('enough') end"));
    ObjectId const box = addBox(run.world->store(), "box", {0, 0});
    run.world->start();
    run.steps(60);
    double const then = run.world->find<Velocity>(box)->value.x;
    EXPECT_NEAR(then, 0.5, 0.02);
    run.steps(60);
    EXPECT_EQ(run.world->find<Velocity>(box)->value.x, then);
    EXPECT_NE(run.game.messages().find("script1.lua:7: enough"), std::string::npos);
}

TEST(ScriptedInteraction, KeepsWhatItsManifestDeclaresAndNothingElse) {
    Play run("local hidden = 0\n" +
             scriptOf("hidden = hidden + 1\nstore.object.turns = store.object.turns + 1\n"
                      "store.script.all = store.script.all + hidden\n"
                      "log(store.object.turns, hidden, store.script.all)",
                      "restless = true, each = { \"Mass\" }, store = { object = { turns = 0 }, "
                      "script = { all = 0 } },"));
    addBox(run.world->store(), "a", {0, 0});
    addBox(run.world->store(), "b", {5, 0});
    run.world->start();
    std::uint64_t const before = run.world->stateHash();
    run.steps(2);
    // In each turn `hidden` begins at 0 again; the second object of the turn sees the change by the first.
    EXPECT_EQ(run.game.messages(), "1 1 1\n1 2 3\n2 1 4\n2 2 6\n");
    EXPECT_NE(run.world->stateHash(), before);
}

TEST(ScriptedInteraction, HasOneHashOnAnyNumberOfThreadsAndInEveryRun) {
    std::string const source = scriptOf(
        "local push = vec2(frame.random() - 0.5, frame.random() - 0.5)\n"
        "store.object.sum = store.object.sum + push.x\n"
        "for key, value in pairs({ north = 1, south = 2, east = 3, west = 4 }) do push = push * value end\n"
        "out.addForce(object, push * (1000 * math.sin(object.Position.value.x)))",
        "restless = true, each = { \"Mass\" }, store = { object = { sum = 0 } },");
    std::vector<std::uint64_t> hashes;
    for (int const threads : {1, 2, 8, 32, 1}) {
        WorldOptions options;
        options.threads = threads;
        options.rowsWorthThreads = 0;
        Play run(source, options);
        for (int i = 0; i < 50; ++i) {
            addBox(run.world->store(), "box " + std::to_string(i), {2.0 * i, 0});
        }
        run.world->start();
        run.steps(120);
        EXPECT_EQ(run.game.messages(), "");
        hashes.push_back(run.world->stateHash());
    }
    for (std::uint64_t const hash : hashes) {
        EXPECT_EQ(hash, hashes.front());
    }
}

TEST(ScriptedInteraction, ReadsListsHandlesAndTheWorld) {
    Play run("return interaction { name = \"Dynamics <- Test\", calls = \"Dynamics\",\n"
             "reads = { \"contacts\", \"Mass\", \"Gravity\" }, once = true,\n"
             "apply = function(world, params, out)\n"
             "  for _, pair in ipairs(world.contacts.begun) do\n"
             "    log(pair.a.Mass.value, alive(pair.b), same(pair.a, pair.b), world.Gravity.value)\n"
             "  end\nend }");
    Store& store = run.world->store();
    store.column<GravityField>().set(store.create("world"), {{0, -10}});
    addBox(store, "a", {0, 0});
    addBox(store, "b", {0, 1.05});
    ObjectId const c = addBox(store, "floor", {0, -1});
    store.column<Fixed>().set(c, {});
    run.world->start();
    run.steps(60);
    std::string const said = run.game.messages();
    EXPECT_NE(said.find("1000 true false (0, -10)"), std::string::npos) << said;
    EXPECT_EQ(said.find("error"), std::string::npos) << said;
}

// A box that touches the floor is taken out of the world. The pair of the contact that ended holds its
// handle.
TEST(ScriptedInteraction, ReportsAStaleHandleAsAnError) {
    std::string const destroying =
        "return interaction { name = \"Population <- Test\", calls = \"Population\",\n"
        "reads = { \"contacts\", \"Fixed\" }, once = true,\n"
        "apply = function(world, params, out)\n"
        "  for _, pair in ipairs(world.contacts.begun) do\n"
        "    out.destroyObject(pair.a.Fixed and pair.b or pair.a)\n  end\nend }";
    struct Case {
        std::string use;
        std::string message;
    };
    std::vector<Case> const cases{
        {"local mass = gone.Mass", "the object whose 'Mass' is read is gone"},
        {"out.addForce(gone, vec2(1, 0))", "argument 'object' of addForce is an object that is gone"},
    };
    for (Case const& one : cases) {
        ScriptedGame const game(
            {destroying, "return interaction { name = \"Dynamics <- Test\", calls = \"Dynamics\",\n"
                         "reads = { \"contacts\", \"Mass\" }, once = true,\n"
                         "apply = function(world, params, out)\n"
                         "  for _, pair in ipairs(world.contacts.ended) do\n"
                         "    local gone = alive(pair.a) and pair.b or pair.a\n    " +
                             one.use + "\n  end\nend }"});
        World world(game.registry);
        Store& store = world.store();
        store.column<GravityField>().set(store.create("world"), {{0, -10}});
        ObjectId const box = addBox(store, "box", {0, 0.05});
        store.column<Fixed>().set(addBox(store, "floor", {0, -1}), {});
        world.start();
        for (int i = 0; i < 60; ++i) {
            world.step();
        }
        EXPECT_FALSE(store.alive(box));
        std::string const said = game.messages();
        EXPECT_NE(said.find(one.message), std::string::npos) << said;
    }
}

TEST(ScriptedInteraction, HasATurnInEveryNthFrameIfItHasAPeriod) {
    Play run(scriptOf("out.addForce(object, vec2(1000, 0))", "restless = true, each = { \"Mass\" },"));
    addBox(run.world->store(), "box", {0, 0});
    run.world->start();
    run.world->setPeriod("Dynamics <- Test", 4);
    run.steps(12);
    EXPECT_EQ(run.game.messages(), "");
    EXPECT_EQ(statusOf(*run.world, "Dynamics <- Test").updates, 3U);
}

TEST(ScriptedInteraction, IsACauseInTheTrace) {
    WorldOptions options;
    options.trace = true;
    Play run(scriptOf("out.addForce(object, vec2(1000, 0))"), options);
    addBox(run.world->store(), "box", {0, 0});
    run.world->start();
    run.steps(3);
    int calls = 0;
    for (Event const& event : run.world->tracer()->events()) {
        if (event.component == "Dynamics <- Test") {
            EXPECT_EQ(event.event, "addForce");
            EXPECT_EQ(event.objects, std::vector<std::string>{"box"});
            ++calls;
        }
    }
    EXPECT_EQ(calls, 1) << "a held call is an event when it is new";
}

TEST(ScriptedInteraction, IsAppliedToObjectsThatNameItWithTheirOwnParameters) {
    Play run(
        "return interaction { name = \"Dynamics <- Test\", calls = \"Dynamics\", reads = {}, attached = "
        "true,\n"
        "each = { \"Mass\" }, params = { force = { default = 500, min = 0, max = 5000, unit = \"N\" } },\n"
        "apply = function(object, params, out) out.addForce(object, vec2(params.force, 0)) end }");
    Store& store = run.world->store();
    ObjectId const plain = addBox(store, "plain", {0, 0});
    ObjectId const usual = addBox(store, "usual", {0, 5});
    ObjectId const strong = addBox(store, "strong", {0, 10});
    store.column<Scripts>().set(usual, {{{"Dynamics <- Test", {}}}});
    store.column<Scripts>().set(strong, {{{"Dynamics <- Test", {{.parameter = "force", .number = 2000}}}}});
    run.world->start();
    run.steps(61);
    EXPECT_EQ(run.game.messages(), "");
    EXPECT_EQ(run.world->find<Velocity>(plain)->value.x, 0);
    EXPECT_NEAR(run.world->find<Velocity>(usual)->value.x, 0.5, 1e-5);
    EXPECT_NEAR(run.world->find<Velocity>(strong)->value.x, 2.0, 1e-5);
}

TEST(ScriptedInteraction, FindsEveryPairThatIsNearLikeAComparisonOfAll) {
    Play run(
        "return interaction { name = \"Dynamics <- Test\", calls = \"Dynamics\", reads = { \"Position\", "
        "\"Mass\" },\n"
        "pairs = { first = { \"Mass\" }, second = { \"Mass\" }, within = 3 },\n"
        "store = { script = { pairs = 0 } }, limits = { log_lines = 10 },\n"
        "apply = function(a, b, params, out, store)\n"
        "  local apart = (a.Position.value - b.Position.value):length()\n"
        "  assert(apart <= 3)\n  store.script.pairs = store.script.pairs + 1\n"
        "  if store.script.pairs % 10 == 0 then log(store.script.pairs) end\nend }");
    std::vector<Vec2> places;
    for (int i = 0; i < 60; ++i) { // a spiral: no two at one place, some near
        double const t = 0.7 * i;
        places.push_back({t * std::cos(t), t * std::sin(t)});
        addBox(run.world->store(), "box " + std::to_string(i), places.back());
    }
    int expected = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        for (std::size_t j = i + 1; j < places.size(); ++j) {
            expected += length(places[i] - places[j]) <= 3 ? 1 : 0;
        }
    }
    run.world->start();
    run.steps(1);
    std::string wanted;
    for (int i = 10; i <= expected; i += 10) {
        wanted += std::to_string(i) + "\n";
    }
    EXPECT_EQ(run.game.messages(), wanted);
}

TEST(ScriptedInteraction, IsSwitchedOffWhereItHasTooManyPairs) {
    Play run(
        "return interaction { name = \"Dynamics <- Test\", calls = \"Dynamics\", reads = { \"Position\" },\n"
        "pairs = { first = { \"Position\" }, second = { \"Position\" }, within = 1000000 },\n"
        "apply = function(a, b, params, out) end }");
    Store& store = run.world->store();
    for (int i = 0; i < 460; ++i) { // 105,570 pairs
        store.column<Position>().set(store.create("point " + std::to_string(i)), {{0.1 * i, 0}});
    }
    addBox(store, "box", {0, 50});
    run.world->start();
    run.steps(2);
    EXPECT_EQ(run.game.messages(),
              "error: the script is applied to more than 100000 pairs of objects in a turn\n");
}

} // namespace
} // namespace trembler::lua
