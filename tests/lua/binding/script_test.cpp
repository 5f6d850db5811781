#include "lua/binding/script.hpp"
#include "runtime/notation/boxes.hpp"
#include "tests/lua/support/script_world.hpp"

namespace trembler::lua {
namespace {

std::string pairScript(std::string const& more) {
    return "return interaction { name = 'Dynamics <- Pair', calls = 'Dynamics', reads = { 'Position' },\n"
           "pairs = { first = { 'Mass', 'Velocity' }, second = { 'Magnetic poles' }, within = 2 },\n" +
           more + " apply = function(a, b, params, out) end }";
}

ComponentInfo const& infoOf(ScriptedGame const& game) {
    for (Registration const& one : game.registry.components()) {
        if (one.info->text.name == "Dynamics <- Pair") {
            return *one.info;
        }
    }
    throw std::out_of_range("no such script");
}

std::string under(NotationBox const& box, std::string const& label) {
    for (NotationRow const& row : box.rows) {
        if (row.label == label) {
            return row.text;
        }
    }
    return "no such row";
}

// No object has to have the properties of both roles.
TEST(ScriptNotation, ShowsTheTwoRolesOfAPairApart) {
    ScriptedGame const game({pairScript("")});
    NotationBox const box = boxOf(game.registry, infoOf(game));
    EXPECT_EQ(under(box, "Pairs of"), "objects with all of {Mass, Velocity}");
    EXPECT_EQ(under(box, "and of"), "objects with all of {Magnetic poles}");
    EXPECT_EQ(under(box, "Activated by"), "no such row");
    EXPECT_EQ(activation(infoOf(game)),
              "pairs of objects with all of {Mass, Velocity} and objects with all of {Magnetic poles}");
}

TEST(ScriptNotation, SaysThatTheFirstOfAPairNamesTheScript) {
    ScriptedGame const game({pairScript("attached = true,")});
    NotationBox const box = boxOf(game.registry, infoOf(game));
    EXPECT_EQ(under(box, "Pairs of"), "objects with all of {Mass, Velocity, Scripts}");
    EXPECT_EQ(under(box, "and of"), "objects with all of {Magnetic poles}");
}

// It is constructed as before: where there are objects with each of the properties.
TEST(ScriptNotation, LeavesAloneWhereAPairScriptIsConstructed) {
    ScriptedGame const game({pairScript("")});
    EXPECT_EQ(infoOf(game).neededAll.size(), 3U);
}

} // namespace
} // namespace trembler::lua
