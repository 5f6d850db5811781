#include "game/ui/panels/script_rows.hpp"
#include "tests/game/ui/player.hpp"

namespace trembler::ui::test {
namespace {

std::string inWords(std::vector<InspectorRow> const& rows) {
    std::string all;
    for (InspectorRow const& row : rows) {
        all += row.name + "|" + row.value + "|" + row.unit + "\n";
    }
    return all;
}

TEST(ScriptRows, ShowWhatCountsForTheObjectWithUnits) {
    auto const data = dataWithMods(dataFolder() / "breeze.json");
    lua::Scripts const scripts{{{"Dynamics <- Breeze", {{.parameter = "speed", .number = 12.5}}}}};
    auto const rows = scriptRows(scripts, data->scripts.get());
    ASSERT_EQ(rows.size(), 6U);
    EXPECT_EQ(rows.front().name, "Dynamics <- Breeze");
    EXPECT_NE(rows.front().value, "") << "what it does";
    std::string const all = inWords(rows);
    EXPECT_NE(all.find("speed|12.5|m/s\n"), std::string::npos) << all;
    EXPECT_NE(all.find("reach|6|m\n"), std::string::npos) << all;
}

TEST(ScriptRows, WithoutTheModShowWhatTheObjectStates) {
    lua::Scripts const scripts{{{"Dynamics <- Wind",
                                 {{.parameter = "speed", .number = 12.5},
                                  {.parameter = "to_the_left", .on = true},
                                  {.parameter = "along", .vector = {1, -2}},
                                  {.parameter = "word", .text = "red"}}}}};
    EXPECT_EQ(inWords(scriptRows(scripts, nullptr)),
              "Dynamics <- Wind||\nspeed|12.5|\nto the left|yes|\nalong|1, -2|\nword|red|\n");
}

} // namespace
} // namespace trembler::ui::test
