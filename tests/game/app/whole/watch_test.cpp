// trembler run --watch: tables on the command line, and the messages for unknown names.
#include "tests/game/app/program.hpp"

#include <algorithm>

namespace trembler::test {
namespace {

class Watching : public InAFolder {
protected:
    [[nodiscard]] static std::vector<std::string> run(std::vector<std::string> const& more) {
        std::vector<std::string> all{"run", levelFile("experiments/1-switched-electromagnet.json").string(),
                                     "--frames", "30"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    static bool contains(std::string const& text, std::string const& part) {
        return text.find(part) != std::string::npos;
    }
};

TEST_F(Watching, WritesATableOfTheNamedNumbers) {
    std::string const file = at("run.csv");
    Ran const ran = runProgram(run({"--watch", "switch.position", "--watch",
                                    "electromagnet.electrical_state.on", "--every", "10", "--csv", file}));
    EXPECT_LT(ran.status, 2) << ran.err;
    std::string const table = contentsOf(file);
    EXPECT_EQ(table.substr(0, table.find('\n')),
              "frame,time [s],switch.position.x [m],switch.position.y [m],electromagnet.electrical_state.on");
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 5) << "a heading, and frames 0, 10, 20 and 30";
    EXPECT_TRUE(contains(table, "\n0,0,-2.1,2.1,\n")) << table;
    // A table on the terminal; messages then go to standard error.
    Ran const shown = runProgram(run({"--watch", "switch.position", "--csv", "-"}));
    EXPECT_TRUE(shown.out.starts_with("frame,time [s],")) << shown.out;
    EXPECT_TRUE(contains(shown.err, "state hash")) << shown.err;
}

TEST_F(Watching, ReportsNamesSimilarToAnUnknownOne) {
    Ran const ran = runProgram(run({"--watch", "swicth.position", "--csv", at("run.csv")}));
    EXPECT_EQ(ran.status, 2);
    EXPECT_TRUE(contains(ran.err, "there is no object 'swicth' (did you mean 'switch'?); the objects are: "))
        << ran.err;
    EXPECT_TRUE(names().empty()) << "no file is left";
    EXPECT_EQ(runProgram(run({"--watch", "switch.position"})).status, 2) << "where to?";
    EXPECT_EQ(runProgram(run({"--csv", at("run.csv")})).status, 2) << "what?";
    EXPECT_EQ(runProgram(run({"--watch", "switch.position", "--csv", at("run.csv"), "--every", "0"})).status,
              2);
    EXPECT_TRUE(contains(runProgram({"run", "--help"}).out, "--watch"));
}

TEST_F(Watching, AColumnWithoutAnyValueIsReported) {
    std::vector<std::string> const what{"--watch", "electromagnet.current", "--watch", "switch.position",
                                        "--watch", "switch.shape.99.width", "--csv",   at("run.csv")};
    Ran const empty = runProgram(run(what));
    EXPECT_LT(empty.status, 2) << empty.err;
    EXPECT_TRUE(contains(empty.err, "'electromagnet.current' had no value in any row: the detail level "
                                    "two-wire of electricity leaves it empty; --detail electricity=nodal"))
        << empty.err;
    EXPECT_TRUE(contains(empty.err, "'switch.shape.99.width' had no value in any row\n")) << empty.err;
    EXPECT_FALSE(contains(empty.err, "switch.position")) << empty.err;
    std::vector<std::string> nodal = run(what);
    nodal.insert(nodal.end(), {"--detail", "electricity=nodal"});
    Ran const filled = runProgram(nodal);
    EXPECT_FALSE(contains(filled.err, "electromagnet.current")) << filled.err;
    EXPECT_TRUE(contains(filled.err, "'switch.shape.99.width'")) << filled.err;
}

TEST_F(Watching, AnInputIsNeverReplacedByATable) {
    std::string const input = level();
    std::string const before = contentsOf(input);
    Ran const ran = runProgram({"run", input, "--watch", "world.gravity", "--csv", input});
    EXPECT_EQ(ran.status, 2);
    EXPECT_EQ(contentsOf(input), before);
}

// The message about a refused change lists the changes that a recording may contain.
TEST_F(Watching, ASolutionWithOtherPhysicsIsRefused) {
    write(at("pull.json"), "{\"name\": \"pull\", \"changes\": [\n"
                           "  {\"frame\": 2, \"setting\": {\"gravity\": {\"value\": 1}}}]}\n");
    Ran const ran = runProgram(run({"--solution", at("pull.json")}));
    EXPECT_EQ(ran.status, 2);
    EXPECT_TRUE(contains(ran.err, "pull.json:2:")) << ran.err;
    EXPECT_TRUE(contains(ran.err, "solver.substeps")) << ran.err;
    Ran const other = runProgram(run({"--detail", "electricity=single-cable", "--record", at("other.json")}));
    EXPECT_EQ(other.status, 2);
    EXPECT_TRUE(contains(other.err, "changes the physics")) << other.err;
}

} // namespace
} // namespace trembler::test
