#include "puzzle/session/refused_solution.hpp"
#include "puzzle/session/session.hpp"
#include "tests/support/experiment.hpp"

namespace trembler {
namespace refused_solution_test {
namespace {

class RefusedSolution : public Experiment {
protected:
    /// A pond, tanks and balls, and a solution that places a ball, then the tank at `x`, then another ball.
    static LevelFile pondWithTankAt(double x) {
        nlohmann::json level = nlohmann::json::parse(R"({"version": 2, "title": "pond",
        "objects": [{"name": "pond", "at": [0, 0], "properties": {"material": "water",
                     "shape": [{"form": "box", "width": 4, "height": 2}],
                     "liquid": {"linear_drag": 1, "quadratic_drag": 1}}}],
        "toolbox": [{"part": "water tank", "count": 2}, {"part": "steel ball", "count": 3}],
        "solutions": [{"name": "some", "placements": [{"part": "steel ball", "at": [9, 3]},
                       {"part": "water tank", "at": [0, 0]}, {"part": "steel ball", "at": [12, 3]}]}]})");
        level["solutions"][0]["placements"][1]["at"][0] = x;
        return readLevel(gameData().registry, JsonDocument::parse(level.dump(1), "pond.json"));
    }
};

TEST_F(RefusedSolution, IsRefusedAtThePlacementThatNoWorldCanBeBuiltWith) {
    Session session(gameData().registry, gameData().parts, pondWithTankAt(1));
    try {
        session.load(session.level().solutions[0]);
        FAIL() << "a tank's water lies in a pond";
    } catch (InputError const& error) {
        ASSERT_GE(error.diagnostics().size(), 2U);
        Diagnostic const& last = error.diagnostics().back();
        EXPECT_EQ(last.file, "pond.json");
        EXPECT_EQ(last.path, "/solutions/0/placements/1");
        EXPECT_GT(last.line, 0U);
        EXPECT_NE(last.message.find("water tank"), std::string::npos);
        EXPECT_NE(error.diagnostics()[0].message.find("overlaps the liquid"), std::string::npos);
    }
    EXPECT_TRUE(session.placed().empty()) << "the placements stay as they were";
}

TEST_F(RefusedSolution, IsNotRefusedBesideThePond) {
    Session session(gameData().registry, gameData().parts, pondWithTankAt(20));
    EXPECT_NO_THROW(session.load(session.level().solutions[0]));
    EXPECT_EQ(session.placed().size(), 3U);
}

TEST_F(RefusedSolution, FindsTheFirstOfManyWithFewQuestions) {
    LevelFile const level = pondWithTankAt(20);
    Solution solution = level.solutions[0];
    solution.placements.assign(1000, solution.placements[0]);
    for (std::size_t i = 0; i < solution.placements.size(); ++i) {
        solution.placements[i].part = "part " + std::to_string(i);
    }
    InputError const error({Diagnostic{"a.json", 1, 1, "/b", "c", "d"}});
    for (std::size_t const bad : {0U, 1U, 499U, 998U, 999U}) {
        int asked = 0;
        auto const builds = [&](std::size_t count) {
            ++asked;
            return count <= bad;
        };
        InputError const told = refusedSolution(level, solution, builds, error);
        ASSERT_EQ(told.diagnostics().size(), 2U);
        EXPECT_NE(told.diagnostics()[1].message.find("'part " + std::to_string(bad) + "'"),
                  std::string::npos);
        EXPECT_EQ(told.diagnostics()[0].message, "c");
        EXPECT_LE(asked, 10);
    }
    auto const all = [](std::size_t) { return true; };
    EXPECT_EQ(refusedSolution(level, solution, all, error).diagnostics().size(), 1U) << "wires are to blame";
}

} // namespace
} // namespace refused_solution_test
} // namespace trembler
