// trembler components --levels: the components that levels activate, in all output formats.
#include "tests/game/app/program.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace trembler::test {
namespace {

using nlohmann::json;

class ComponentsCommand : public InAFolder {};

TEST_F(ComponentsCommand, PrintsAndWritesWhatLevelsActivate) {
    RunAs const how{.environment = {{"TREMBLER_HOME", home().string()}}};
    Ran const printed = runProgram({"components", "--levels", "--json"}, how);
    ASSERT_EQ(printed.status, 0) << printed.err;
    json const all = json::parse(printed.out);
    ASSERT_FALSE(all["plays"].empty()) << printed.out; // one for each of its solutions
    EXPECT_EQ(all["plays"][0]["level"], "levels/level.json");
    std::vector<std::string> active;
    for (json const& component : all["plays"][0]["components"]) {
        if (component["updates"] > 0) {
            active.push_back(component["component"]);
        }
    }
    EXPECT_NE(std::find(active.begin(), active.end(), "Dynamics Resolver"), active.end()) << printed.out;
    EXPECT_EQ(runProgram({"components", "--levels", "--json", at("levels.json")}, how).status, 0);
    EXPECT_EQ(contentsOf(at("levels.json")), printed.out);
    EXPECT_NE(runProgram({"components", "--levels", "--markdown"}, how).out.find("| Dynamics Resolver |"),
              std::string::npos);
    EXPECT_NE(runProgram({"components", "--levels"}, how).out.find("  Dynamics Resolver "),
              std::string::npos);
}

} // namespace
} // namespace trembler::test
