// The causes of a script's calls in the trace: the causes that the host states; a script cannot invent any.
#include "tests/lua/support/script_world.hpp"

#include <algorithm>
#include <span>

namespace trembler::lua {
namespace {

std::string touchingScript(std::string const& body) {
    return "return interaction { name = \"Dynamics <- Test\", calls = \"Dynamics\",\n"
           "reads = { \"Mass\", \"Fixed\" }, pairs = { first = { \"Mass\" }, second = { \"Fixed\" }, "
           "touching = true },\napply = function(a, b, params, out)\n" +
           body + "\nend }";
}

/// Boxes that fall on a floor, traced.
struct TracedFall {
    explicit TracedFall(std::string const& source) : game({source}), world(game.registry, options()) {
        Store& store = world.store();
        store.column<GravityField>().set(store.create("world"), {{0, -10}});
        (void)addBox(store, "a", {-3, 0.05});
        (void)addBox(store, "b", {3, 0.4});
        ObjectId const floor = addBox(store, "floor", {0, -1});
        store.column<Shape>().set(floor, {{boxPiece(10, 1)}});
        store.column<Fixed>().set(floor, {});
        world.start();
        for (int i = 0; i < 40; ++i) {
            world.step();
        }
    }
    static WorldOptions options() {
        WorldOptions made;
        made.trace = true;
        return made;
    }
    ScriptedGame game;
    World world;
};

TEST(ScriptCauses, OfACallOnAPairAreTheContactOfThatPair) {
    TracedFall const fall(touchingScript("out.addForce(a, vec2(1, 0))"));
    EXPECT_EQ(fall.game.messages(), "");
    std::span<Event const> const events = fall.world.tracer()->events();
    int calls = 0;
    for (Event const& call : events) {
        if (call.component != "Dynamics <- Test") {
            continue;
        }
        ++calls;
        ASSERT_EQ(call.causes.size(), 1U);
        auto const cause = std::find_if(events.begin(), events.end(),
                                        [&](Event const& each) { return each.id == call.causes.front(); });
        ASSERT_NE(cause, events.end()) << "an event that does not exist";
        EXPECT_EQ(cause->event, "contact begun");
        EXPECT_LE(cause->frame, call.frame);
        EXPECT_NE(std::find(cause->objects.begin(), cause->objects.end(), call.objects.front()),
                  cause->objects.end())
            << "the contact of another object";
    }
    EXPECT_GE(calls, 2);
}

// A script cannot state a cause: no call has an argument for it, and no value that a script reads is an
// event.
TEST(ScriptCauses, AreNotForAScriptToState) {
    struct Case {
        std::string body;
        std::string said;
    };
    std::vector<Case> const cases{
        {"out.addForce{ object = a, force = vec2(1, 0), cause = 1 }",
         "script1.lua:4: addForce has no argument 'cause'; expected 'object' or 'force'"},
        {"out.addForce{ object = a, force = vec2(1, 0), causes = { 1, 2 } }",
         "addForce has no argument 'causes'"},
        {"out.addForce(a, vec2(1, 0), 1)",
         "addForce is given 3 arguments; expected addForce(object, force: N)"},
        {"local event = a.event",
         "the script does not declare that it reads 'event' of the object; expected 'Mass' or 'Fixed'"},
    };
    for (Case const& one : cases) {
        TracedFall const fall(touchingScript(one.body));
        std::string const said = fall.game.messages();
        EXPECT_NE(said.find(one.said), std::string::npos) << one.body << "\n  " << said;
        for (Event const& event : fall.world.tracer()->events()) {
            EXPECT_FALSE(event.component == "Dynamics <- Test" && event.event == "addForce") << one.body;
        }
    }
}

TEST(ScriptCauses, AreNoneWhereTheHostKnowsNone) {
    TracedFall const fall("return interaction { name = \"Dynamics <- Test\", calls = \"Dynamics\",\n"
                          "reads = { \"Mass\" }, each = { \"Mass\" },\n"
                          "apply = function(object, params, out) out.addForce(object, vec2(1, 0)) end }");
    int calls = 0;
    for (Event const& event : fall.world.tracer()->events()) {
        if (event.component == "Dynamics <- Test") {
            ++calls;
            EXPECT_TRUE(event.causes.empty());
        }
    }
    EXPECT_EQ(calls, 3);
}

// From the contact to the script, and from the script to its resolver's events.
TEST(ScriptCauses, ACallIsTheCauseOfWhatItsResolverDoes) {
    TracedFall const fall(
        "return interaction { name = \"Population <- Test\", calls = \"Population\",\n"
        "reads = { \"Mass\", \"Fixed\" }, pairs = { first = { \"Mass\" }, second = { \"Fixed\" }, "
        "touching = true },\napply = function(a, b, params, out) if not a.Fixed then out.destroyObject(a) "
        "end end }");
    EXPECT_EQ(fall.game.messages(), "");
    std::span<Event const> const events = fall.world.tracer()->events();
    auto const byId = [&](EventId id) {
        return *std::find_if(events.begin(), events.end(), [&](Event const& each) { return each.id == id; });
    };
    int destroyed = 0;
    for (Event const& event : events) {
        if (event.event != "destroyed") {
            continue;
        }
        ++destroyed;
        ASSERT_EQ(event.causes.size(), 1U);
        Event const call = byId(event.causes.front());
        EXPECT_EQ(call.component, "Population <- Test");
        EXPECT_EQ(call.event, "destroyObject");
        EXPECT_EQ(call.frame + 1, event.frame);
        ASSERT_EQ(call.causes.size(), 1U);
        EXPECT_EQ(byId(call.causes.front()).event, "contact begun");
    }
    EXPECT_EQ(destroyed, 2);
}

} // namespace
} // namespace trembler::lua
