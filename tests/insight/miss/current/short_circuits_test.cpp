// A battery whose ends are joined by plain metal.
#include "insight/miss/current/short_circuits.hpp"
#include "insight/why/words/words.hpp"
#include "physics/electricity/properties/quantities.hpp"
#include "puzzle/session/session.hpp"
#include "runtime/level/json/json_document.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/insight/support/explained_miss.hpp"
#include "tests/support/game_data.hpp"

#include <gtest/gtest.h>

namespace trembler::insight {
namespace short_circuits_test {
namespace {

/// A battery that feeds what `load` is, with a spanner that lies loose unless `more` wires it up.
LevelFile batteryWith(std::string const& load, std::string const& more) {
    std::string const text = R"({"version": 2, "title": "A battery",
  "world": {"gravity": [0, 0], "bounds": [-10, -10, 20, 20]},
  "objects": [
    {"name": "power", "part": "battery", "at": [-3, 0]},
    {"name": "spanner", "at": [0, 3], "properties": {"conductor": true}},
    {"name": "load", "at": [3, 0], )" +
                             load +
                             R"(}],
  "connections": [["power plus", "load"], ["load", "power minus"])" +
                             more + R"(], "goals": {"on": "load"}})";
    return readLevel(gameData().registry, JsonDocument::parse(text, "battery.json"));
}

std::string const dim = R"("properties": {"conductor": true, "resistance": 24})";
std::string const across = R"(, ["power plus", "spanner"], ["spanner", "power minus"])";

std::vector<std::string> shortsOf(LevelFile const& level) {
    Session session(gameData().registry, gameData().parts, level, {});
    session.start();
    session.step();
    session.step();
    std::vector<std::string> names;
    for (ObjectId const id : shortCircuits(session.world())) {
        names.push_back(session.world().store().nameOf(id));
    }
    return names;
}

TEST(ShortCircuits, AreFoundWherePlainMetalJoinsBothEnds) {
    EXPECT_EQ(shortsOf(batteryWith(dim, "")), std::vector<std::string>{});
    EXPECT_EQ(shortsOf(batteryWith(dim, R"(, ["power plus", "spanner"])")), std::vector<std::string>{});
    EXPECT_EQ(shortsOf(batteryWith(dim, across)), std::vector<std::string>{"power plus"});
}

// A coil without a resistance of its own takes the whole voltage of a battery, and works.
TEST(ShortCircuits, AreNotSaidOfACircuitInWhichADeviceWorks) {
    std::string const coil = R"("part": "electromagnet")";
    EXPECT_EQ(shortsOf(batteryWith(coil, "")), std::vector<std::string>{});
    EXPECT_EQ(shortsOf(batteryWith(coil, across)), std::vector<std::string>{"power plus"});
}

TEST(ShortCircuits, AreTheReasonWhyALoadIsOff) {
    LevelFile const level = batteryWith(dim, across);
    Miss const miss = explainedMiss(level, 10);
    EXPECT_EQ(miss.lack, Lack::shorted);
    std::vector<std::string> const said = sentencesOf(miss, AnswerLanguage());
    ASSERT_FALSE(said.empty());
    EXPECT_EQ(said.front(),
              "No current flowed through the load: the power plus was short-circuited, at the start.");
}

} // namespace
} // namespace short_circuits_test
} // namespace trembler::insight
