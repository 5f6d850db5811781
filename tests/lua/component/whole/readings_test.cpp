// What a script reads cannot be changed, in whatever way it is read; looking through it works.
#include "tests/lua/support/script_world.hpp"

namespace trembler::lua {
namespace {

constexpr char const* assigns = "local own = {} own.field = 1 ";

/// What a script says that is run once, as soon as two objects touch.
std::string saidBy(std::string const& body, Trust trust) {
    ScriptedGame const game(
        {"return interaction { name = \"Dynamics <- Test\", calls = \"Dynamics\", once = true, restless = "
         "true,\n"
         "reads = { \"contacts\", \"Mass\", \"Gravity\", \"Position\" }, store = { script = { done = false, "
         "v = vec2(1, 2) } },\n"
         "params = { to = { default = vec2(3, 4) } }, apply = function(world, params, out, store)\n"
         "  if #world.contacts.current == 0 or store.script.done then return end\n"
         "  store.script.done = true\n  " +
         body + "\nend }"},
        trust);
    World world(game.registry);
    Store& store = world.store();
    store.column<GravityField>().set(store.create("world"), {{0, -10}});
    (void)addBox(store, "a", {0, 0.01});
    store.column<Fixed>().set(addBox(store, "floor", {0, -1}), {});
    world.start();
    for (int i = 0; i < 30; ++i) {
        world.step();
    }
    return game.messages();
}

TEST(Readings, CannotBeChanged) {
    struct Case {
        std::string body;
        std::string message;
    };
    std::vector<Case> const cases{
        {"world.Gravity = 3", "'Gravity' cannot be changed"},
        {"world.Gravity.value = vec2(0, 7)", "'value' cannot be changed"},
        {"world.Gravity.foo = { 1 }", "'foo' cannot be changed"},
        {"world.contacts.current = {}", "'current' cannot be changed"},
        {"world.contacts.current[1] = {}", "'[1]' cannot be changed"},
        {"local list = world.contacts.current list[#list + 1] = 3", "'[2]' cannot be changed"},
        {"world.contacts.current[1].a = {}", "'a' cannot be changed"},
        {"for _, pair in ipairs(world.contacts.current) do pair.b = nil end", "'b' cannot be changed"},
        {"for _, pair in pairs(world.contacts.current) do pair.b = nil end", "'b' cannot be changed"},
        {"local list = select(2, ipairs(world.contacts.current)) list[1] = 3", "'[1]' cannot be changed"},
        {"world.contacts.current[1].a.Mass.value = 3", "'value' cannot be changed"},
        {"world.contacts.current[1].a.Position.value.y = 3",
         "'y' of a vector that was read cannot be changed"},
        {"world.Gravity.value.x = 5", "'x' of a vector that was read cannot be changed"},
        {"store.script.v.x = 5",
         "expected another vector, vec2(x, y), as in store.object.speed = vec2(x, y)"},
        {"params.to.x = 5", "'x' of a vector that was read cannot be changed"},
        {"table.insert(world.contacts.current, 3)",
         "argument 'list' of table.insert is a table; expected a table"},
        {"table.sort(world.contacts.current)", "argument 'list' of table.sort is a table; expected a table"},
        {"table.remove(world.contacts.current)",
         "argument 'list' of table.remove is a table; expected a table"},
        {"setmetatable(world.Gravity, {})", "argument 'table' of setmetatable is a table; expected a table"},
        {"local x = world.Gravity.valeu", "has no 'valeu' (did you mean 'value'?)"},
        {"local x = world.contacts.curent", "has no 'curent' (did you mean 'current'?)"},
        {"local x = world.contacts.current[1].a.Mass.valeu", "has no 'valeu' (did you mean 'value'?)"},
    };
    for (Trust const trust : {Trust::untrusted, Trust::trusted}) {
        for (Case const& one : cases) {
            for (char const* const before : {"", assigns}) {
                std::string const said = saidBy(before + one.body, trust);
                EXPECT_NE(said.find(one.message), std::string::npos) << before << one.body << "\n  " << said;
            }
        }
    }
}

// A vector that a script has made of what it has read is its own.
TEST(Readings, AreLookedThroughAsTablesOfTheScriptsOwn) {
    std::string const looks =
        "local list = world.contacts.current "
        "for i, pair in ipairs(list) do log(i, pair.a ~= pair.b, pair.none) end "
        "for i, pair in pairs(list) do log(i, pair.a.Mass.value) end "
        "for key, value in pairs(list[1]) do log(key, type(value)) end "
        "for key, value in pairs(world.Gravity) do log(key, value) end "
        "log(#list, list[#list + 1], next(list) == 1, type(list), tostring(list), #{ unpack(list) }, "
        "(getmetatable(list))) "
        "local v = world.Gravity.value * 2 log(v, world.Gravity.value == vec2(0, -10), v:length())";
    std::string const expected = saidBy(looks, Trust::untrusted);
    EXPECT_NE(expected.find("1 nil true table table 1 false\n(0, -20) true 20\n"), std::string::npos)
        << expected;
    for (Trust const trust : {Trust::untrusted, Trust::trusted}) {
        EXPECT_EQ(saidBy(looks, trust), expected);
        EXPECT_EQ(saidBy(assigns + looks, trust), expected);
        EXPECT_EQ(saidBy("local v = world.Gravity.value + vec2(0, 0) v.x = 3 log(v)", trust), "(3, -10)\n");
    }
}

TEST(Readings, TheLengthIsThatOfLuaInEveryScript) {
    std::string const lengths = "local t = { 1, 2, { 1, n = { 'ab' } } } local function f() return#t end "
                                "log(#t, -#t, #'ab' .. 'c', #t * 2 + 1, not #t, #t == 3, #t[3].n[1], "
                                "#t[#t].n, f(), #{ #t, #'x' }, 1 - #t, #t/#t)";
    for (Trust const trust : {Trust::untrusted, Trust::trusted}) {
        for (char const* const before : {"", assigns}) {
            EXPECT_EQ(saidBy(before + lengths, trust), "3 -3 2c 7 false true 2 1 3 2 -2 1\n") << before;
        }
    }
}

} // namespace
} // namespace trembler::lua
