// Scripts' reads of derived property sets: by a list of the world, which is read once in a turn, and by
// handles from it.
#include "tests/lua/support/script_world.hpp"

#include <fmt/format.h>

namespace trembler::lua {
namespace {

constexpr char const* weighing = "return interaction { name = \"Dynamics <- Test\", calls = \"Dynamics\",\n"
                                 "reads = { \"gravity_force\", \"Mass\" }, once = true,\n"
                                 "apply = function(world, params, out)\n"
                                 "  assert(world.gravity_force == world.gravity_force)\n"
                                 "  for _, entry in ipairs(world.gravity_force.forces) do\n"
                                 "    log(entry.object.Mass.value, entry.force.y, entry.rate)\n"
                                 "    out.addForce(entry.object, -entry.force)\n  end\nend }";

// A script sees the values that the set has derived in this frame, not those of an earlier one: each turn
// reads them once, and the next turn again.
TEST(DerivedReads, AreThoseOfThisFrame) {
    for (Trust const trust : {Trust::untrusted, Trust::trusted}) {
        ScriptedGame game({weighing}, trust);
        World world(game.registry);
        Store& store = world.store();
        ObjectId const all = store.create("world");
        store.column<GravityField>().set(all, {{0, -10}});
        ObjectId const box = addBox(store, "box", {0, 0});
        world.start();
        for (int i = 0; i < 6; ++i) {
            if (i == 2) {
                store.column<Mass>().set(box, {500});
            } else if (i == 4) {
                store.column<GravityField>().set(all, {{0, -4}});
            }
            world.step();
            Vec2 const force = world.find<GravityForce>()->forces.at(0).force;
            std::string const said = game.messages();
            std::string const expected =
                fmt::format("{} {} 0\n", store.column<Mass>().find(box)->value, force.y);
            EXPECT_EQ(said, i % 2 == 0 ? expected : "") << "frame " << i << ": it sleeps in between";
        }
        EXPECT_EQ(statusOf(world, "Dynamics <- Test").updates, 3U);
    }
}

TEST(DerivedReads, HaveWeightAndCounterForceCancelled) {
    ScriptedGame game({weighing});
    World world(game.registry);
    Store& store = world.store();
    store.column<GravityField>().set(store.create("world"), {{0, -10}});
    ObjectId const box = addBox(store, "box", {0, 0});
    world.start();
    for (int i = 0; i < 60; ++i) {
        world.step();
    }
    EXPECT_NEAR(world.find<Velocity>(box)->value.y, 0, 1e-4);
}

// No script can write into the lists that it was shown; it may keep the values in lists of its own.
TEST(DerivedReads, AreShownAnewInEachTurn) {
    ScriptedGame game(
        {"return interaction { name = \"Dynamics <- Test\", calls = \"Dynamics\", once = true,\n"
         "reads = { \"gravity_force\" }, restless = true, apply = function(world)\n"
         "  local seen = world.gravity_force\n  log(#seen.forces, seen.forces[1].force.y)\n"
         "  log((pcall(function() seen.forces[1].force = vec2(0, 7) end)), (pcall(function() seen.forces[2] "
         "= 3 end)))\n"
         "  log(#world.gravity_force.forces, world.gravity_force.forces[1].force.y)\nend }"});
    World world(game.registry);
    Store& store = world.store();
    store.column<GravityField>().set(store.create("world"), {{0, -10}});
    (void)addBox(store, "box", {0, 0});
    world.start();
    for (int i = 0; i < 3; ++i) {
        world.step();
        EXPECT_EQ(game.messages(), "1 -10000\nfalse false\n1 -10000\n") << "frame " << i;
    }
    EXPECT_EQ(world.find<GravityForce>()->forces.at(0).force.y, -10000);
}

TEST(DerivedReads, AreErrorsInWordsWhereTheyAreWrong) {
    struct Case {
        std::string use;
        std::string said;
    };
    for (Case const& one : std::vector<Case>{
             {"local f = world.gravity_forces", "reads 'gravity_forces' of the world (did you mean "
                                                "'gravity_force'?); expected 'gravity_force' or 'Mass'"},
             {"world.gravity_force = nil", "'gravity_force' cannot be changed"},
             {"out.update()", "Dynamics has no function 'update'"}}) {
        ScriptedGame game(
            {"return interaction { name = \"Dynamics <- Test\", calls = \"Dynamics\", once = true,\n"
             "reads = { \"gravity_force\", \"Mass\" }, apply = function(world, params, out)\n" +
             one.use + "\nend }"});
        World world(game.registry);
        Store& store = world.store();
        store.column<GravityField>().set(store.create("world"), {{0, -10}});
        (void)addBox(store, "box", {0, 0});
        world.start();
        world.step();
        std::string const said = game.messages();
        EXPECT_TRUE(said.starts_with("error: script1.lua:3: ")) << said;
        EXPECT_NE(said.find(one.said), std::string::npos) << said;
    }
}

// A derived property set has no functions, so a script cannot name one as its resolver.
TEST(DerivedReads, NoScriptCallsADerivedPropertySet) {
    try {
        ScriptedGame const game({"return interaction { name = \"Linear Gravity <- Test\", calls = \"Linear "
                                 "Gravity\", reads = {}, once = true,\napply = function() end }"});
        FAIL() << "it is accepted";
    } catch (InputError const& error) {
        EXPECT_NE(std::string(error.what()).find("there is no resolver 'Linear Gravity' to call"),
                  std::string::npos)
            << error.what();
    }
}

} // namespace
} // namespace trembler::lua
