// Vectors that are handed to calls as two numbers: where, where not, and that nothing else changes.
#include "lua/sandbox/source/counted_source.hpp"
#include "lua/sandbox/source/spread_vectors.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "tests/lua/support/script_world.hpp"

namespace trembler::lua {
namespace {

VectorArguments const& known() {
    static VectorArguments const all{
        .parameter = 3,
        .calls = {{"push", {false, true}}, {"pushAt", {false, true, true}}, {"turn", {false, false}}}};
    return all;
}

std::string spread(std::string const& text) {
    std::optional<BlockFault> fault;
    CountedSource const made = countSource(text, fault, false, &known());
    EXPECT_FALSE(fault) << text;
    std::string const begin = "return function(...) ";
    std::size_t const from = made.text.find(begin) + begin.size();
    return made.text.substr(from, made.text.rfind("\nend") - from);
}
std::string applyOf(std::string const& body, std::string const& parameters = "o, p, out") {
    return "return interaction { apply = function(" + parameters + ") " + body + " end }";
}

TEST(SpreadVectors, AreThoseThatAreMadeForACallOnly) {
    EXPECT_EQ(spread(applyOf("out.push(o, vec2(1, p.b))")), applyOf("__numbers.push(o, (1),( p.b))"));
    EXPECT_EQ(spread(applyOf("out.push(o, vec2(f(1, 2), { 3, 4 }[1]))")),
              applyOf("__numbers.push(o, (f(1, 2)),( { 3, 4 }[1]))"));
    EXPECT_EQ(spread(applyOf("out.pushAt(o, vec2(1, 2), vec2(3, 4))")),
              applyOf("__numbers.pushAt(o, (1),( 2), (3),( 4))"));
    EXPECT_EQ(spread(applyOf("out.push(o, vec2(1, -- one\n 2))")),
              applyOf("__numbers.push(o, (1),( -- one\n 2))"));
    // A call may have several values, which vec2 would not take.
    EXPECT_EQ(spread(applyOf("out.push(o, vec2(f(), 2))")), applyOf("__numbers.push(o, (f()),( 2))"));
    EXPECT_EQ(spread(applyOf("out.push(o, vec2(1, f()))")), applyOf("__numbers.push(o, (1), f())"));
    EXPECT_EQ(spread(applyOf("out.push(o, vec2(1, f'a'))")), applyOf("__numbers.push(o, (1), f'a')"));
    EXPECT_EQ(spread(applyOf("out.pushAt(o, vec2(1, 2), vec2(3, f{}))")),
              applyOf("__numbers.pushAt(o, (1),( 2), (3), f{})"));
    std::string const inside =
        spread(applyOf("local function f() call.push(o, vec2(1, 2)) end", "o, p, call"));
    EXPECT_NE(inside.find("__numbers.push(o, (1),( 2)) end"), std::string::npos) << inside;
}

TEST(SpreadVectors, AreNoOthers) {
    for (std::string const body :
         {"local v = vec2(1, 2) out.push(o, v)", "out.push(o, vec2(1, 2) * 2)", "out.push(o, -vec2(1, 2))",
          "out.push(o, vec2(1, 2):unit())", "out.push(o, vec2(1))", "out.push(o, vec2(1, 2, 3))",
          "out.push(o, vec2(...))", "out.pushAt(o, vec2(1, f()), vec2(3, 4))", "out.push(o, vec2\n(1, 2))",
          "out.push(o, (vec2(1, 2)))", "out.push(vec2(1, 2), o)", "out.push(o, a, vec2(1, 2))",
          "out.turn(o, vec2(1, 2))", "out.other(o, vec2(1, 2))", "out:push(o, vec2(1, 2))",
          "p.out.push(o, vec2(1, 2))", "out.pushAt(o, v, vec2(1, 2))", "out.pushAt(o, vec2(1, 2), v)",
          "out.push(o, vec2((function() return 1, 2 end)(), 2))",
          // 'out' or 'vec2' may be something else.
          "out = p out.push(o, vec2(1, 2))", "local out = p out.push(o, vec2(1, 2))",
          "local q, out = o, p out.push(o, vec2(1, 2))", "for out in p do out.push(o, vec2(1, 2)) end",
          "local function f(out) out.push(o, vec2(1, 2)) end", "local vec2 = p out.push(o, vec2(1, 2))",
          "local q, vec2 (p)() out.push(o, vec2(1, 2))", "vec2 = p out.push(o, vec2(1, 2))",
          "local function vec2(x, y) end out.push(o, vec2(1, 2))",
          "local function f(vec2) out.push(o, vec2(1, 2)) end",
          "for vec2 = 1, 2 do out.push(o, vec2(1, 2)) end",
          // Not all vectors are stated: the function behind it could not tell.
          "out.pushAt(o, vec2(1, 2))"}) {
        std::optional<BlockFault> fault;
        std::string const text = applyOf(body);
        EXPECT_EQ(spread(text), [&] {
            std::string plain = countSource(text, fault).text;
            std::string const begin = "return function(...) ";
            std::size_t const from = plain.find(begin) + begin.size();
            return plain.substr(from, plain.rfind("\nend") - from);
        }()) << body;
    }
    std::string const reachable = "local apply = f return interaction { apply = function(o, p, out) "
                                  "out.push(o, vec2(1, 2)) end }";
    EXPECT_EQ(spread(reachable).find("__numbers"), std::string::npos) << "something else may call it";
}

struct SpreadOutcome {
    std::vector<std::uint64_t> hashes;
    std::vector<ScriptMessage> messages;
};

SpreadOutcome outcomeOf(std::string const& x, std::string const& y, std::string const& made, Trust trust) {
    std::string const body =
        "local function one() return 1 end local function two() return 1, 2 end local function none() end "
        "local function last() return 1, nil end " +
        (made.empty() ? "out.addForce(object, vec2(" + x + ", " + y + "))" : made);
    ScriptedGame const game({"return interaction { name = 'Dynamics <- Test', calls = 'Dynamics', reads = { "
                             "'Position', 'Mass' }, each = { 'Mass' }, restless = true,\n"
                             "apply = function(object, params, out)\n" +
                             body + "\nend }"},
                            trust);
    World world(game.registry);
    Store& store = world.store();
    (void)addBox(store, "a", {0, 0.5}, {-0.0, 2});
    (void)addBox(store, "b", {-3, 2.5});
    world.start();
    SpreadOutcome seen;
    for (int frame = 0; frame < 4; ++frame) {
        world.step();
        seen.hashes.push_back(world.stateHash());
    }
    seen.messages = game.log->take();
    return seen;
}

// The same calls, bit for bit, as with a vector that is made first; and an error where there was one.
TEST(SpreadVectors, ChangeNoCall) {
    std::vector<std::string> const expressions{"1",
                                               "-0.0",
                                               "object.Position.value.x",
                                               "-object.Position.value.y * 0",
                                               "1e300 * 1e300",
                                               "0 / 0",
                                               "nil",
                                               "'1'",
                                               "{}",
                                               "setmetatable({}, { __unm = function() return 1 end })",
                                               "vec2(1, 2)",
                                               "true",
                                               "object",
                                               "1e-310",
                                               "(function() return 1, 2 end)()",
                                               "one()",
                                               "two()",
                                               "none()",
                                               "last()",
                                               "(two())",
                                               "math.abs(-2)",
                                               "object.Mass.value / 3"};
    for (Trust const trust : {Trust::untrusted, Trust::trusted}) {
        for (std::string const& x : expressions) {
            for (std::string const& y : {expressions[0], expressions[1], x}) {
                SCOPED_TRACE(x + ", " + y);
                SpreadOutcome const spread = outcomeOf(x, y, {}, trust);
                SpreadOutcome const made =
                    outcomeOf(x, y, "local v = vec2(" + x + ", " + y + ") out.addForce(object, v)", trust);
                EXPECT_EQ(spread.hashes, made.hashes);
                EXPECT_EQ(spread.messages.size(), made.messages.size());
            }
        }
    }
}

// As for any other argument: the script, the line, the argument, its value and the expected one.
TEST(SpreadVectors, ErrorsAreInTheWordsOfArguments) {
    struct Case {
        std::string x;
        std::string y;
        std::string said;
    };
    std::vector<Case> const cases{
        {"nil", "1", "is vec2 of nil and a number; expected vec2(x, y) of two numbers, in N"},
        {"1", "nil", "is vec2 of a number and nil; expected vec2(x, y) of two numbers, in N"},
        {"nil", "nil", "is vec2 of nil and nil; expected"},
        {"'1'", "2", "is vec2 of a string and a number; expected"},
        {"object.Position.value", "2", "is vec2 of a vector and a number; expected"},
        {"object", "2", "is vec2 of an object and a number; expected"},
        {"true", "{}", "is vec2 of a boolean and a table; expected"},
        {"1e300", "0", "is 1e+300 N; expected -1e+"},
        {"0 / 0", "0", "is not finite; expected a number"},
    };
    for (Trust const trust : {Trust::untrusted, Trust::trusted}) {
        for (Case const& one : cases) {
            SpreadOutcome const seen = outcomeOf(one.x, one.y, {}, trust);
            ASSERT_EQ(seen.messages.size(), 1U);
            std::string const expected = "script1.lua:3: argument 'force' of addForce " + one.said;
            EXPECT_EQ(seen.messages[0].text.substr(0, expected.size()), expected) << seen.messages[0].text;
        }
    }
}

TEST(SpreadVectors, TheirFunctionsCannotBeNamed) {
    std::optional<BlockFault> fault;
    (void)countSource(applyOf("__numbers.push(o, 1, 2)"), fault, false, &known());
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->message, "the name '__numbers' is the host's");
}

} // namespace
} // namespace trembler::lua
