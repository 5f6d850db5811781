// The checks of a level: each kind of wrong level is reported, and a right one is not.
#include "puzzle/solutions/verify.hpp"
#include "tests/support/experiment.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <vector>

namespace trembler {
namespace verify_test {
namespace {

/// The content of a level: a rubber ball that rests on the floor, and another one that falls 2 m.
struct Stated {
    std::string members; ///< of the file, each with a comma after it
    std::string goals;   ///< empty: none
    std::string solutions;
};

/// A steel ball that falls onto the side of the resting ball, and one that falls far from it.
std::string const pushes = R"({"name": "push", "placements": [{"part": "steel ball", "at": [0.25, 2]}]})";
std::string const misses = R"({"name": "miss", "expect": "unsolved", "frames": 240,
                               "placements": [{"part": "steel ball", "at": [2, 2]}]})";
/// Goals: reached by a push only; reached by falling; and never reached.
std::string const pushed = R"({"moved": {"object": "resting", "by": 0.1}})";
std::string const fallen = R"({"touching": ["falling", "floor"]})";
std::string const never = R"({"moved": {"object": "resting", "by": 100, "towards": "up"}})";

class Verify : public Experiment {
protected:
    Verify()
        : file_(std::filesystem::path(testing::TempDir()) /
                (std::string("verify_") + testing::UnitTest::GetInstance()->current_test_info()->name() +
                 ".json")) {}
    ~Verify() override {
        std::error_code ignored;
        std::filesystem::remove(file_, ignored);
    }

    [[nodiscard]] std::vector<std::string> failuresOf(Stated const& stated) const {
        std::ofstream(file_) << R"({"version": 2, "title": "balls", )" << stated.members
                             << R"("world": {"gravity": [0, -10], "bounds": [-5, -1, 10, 10]},
            "objects": [
              {"name": "floor", "at": [0, -0.25], "properties": {"material": "stone", "fixed": true,
                "shape": [{"form": "box", "width": 10, "height": 0.5}]}},
              {"name": "resting", "part": "rubber ball", "at": [0, 0.15]},
              {"name": "falling", "part": "rubber ball", "at": [-3, 2.15]}],
            "toolbox": [{"part": "steel ball"}])"
                             << (stated.goals.empty() ? "" : ", \"goals\": " + stated.goals)
                             << ", \"solutions\": [" << stated.solutions << "]}";
        return verifyLevel(gameData(), file_);
    }
    [[nodiscard]] static std::string lines(std::vector<std::string> const& failures) {
        std::string all;
        for (std::string const& failure : failures) {
            all += failure + "\n";
        }
        return all;
    }

    std::filesystem::path file_;
};

TEST_F(Verify, FindsNothingWrongWithALevelThatIsRight) {
    auto const failures = failuresOf({"", pushed, pushes + ", " + misses});
    EXPECT_TRUE(failures.empty()) << lines(failures);
}

TEST_F(Verify, ReportsSolutionsThatEndOtherwise) {
    std::string const unsolved = R"({"name": "push", "expect": "unsolved", "frames": 240,
                                     "placements": [{"part": "steel ball", "at": [0.25, 2]}]})";
    std::string const solved = R"({"name": "miss", "frames": 240,
                                   "placements": [{"part": "steel ball", "at": [2, 2]}]})";
    auto const failures = failuresOf({"", pushed, unsolved + ", " + solved});
    ASSERT_EQ(failures.size(), 2U) << lines(failures);
    EXPECT_NE(failures[0].find("'push'"), std::string::npos) << failures[0];
    EXPECT_NE(failures[1].find("'miss'"), std::string::npos) << failures[1];
}

TEST_F(Verify, ReportsPartsWhereNoPlayerCouldPlaceThem) {
    // Half in the floor, and half in the resting ball.
    std::string const inFloor = R"({"name": "deep", "expect": "unsolved", "frames": 10,
                                    "placements": [{"part": "steel ball", "at": [2, 0]}]})";
    std::string const inBall = R"({"name": "inside", "expect": "unsolved", "frames": 1,
                                   "placements": [{"part": "steel ball", "at": [0.1, 0.3]}]})";
    std::string const said = lines(failuresOf({"", pushed, pushes + ", " + inFloor + ", " + inBall}));
    EXPECT_NE(said.find("'deep': a player cannot place the steel ball"), std::string::npos) << said;
    EXPECT_NE(said.find("at (2, 0): it would overlap the floor"), std::string::npos) << said;
    EXPECT_NE(said.find("'inside': a player cannot place"), std::string::npos) << said;
    EXPECT_EQ(said.find("'push': a player"), std::string::npos) << said;
}

TEST_F(Verify, ReportsALevelThatSolvesItself) {
    auto const failures = failuresOf({"", fallen, pushes});
    ASSERT_EQ(failures.size(), 1U) << lines(failures);
    std::string const& said = failures.front();
    // A fall of 2 m at 10 m/s² takes √0.4 s.
    double const frame = std::stod(said.substr(said.find_last_not_of("0123456789") + 1));
    EXPECT_NEAR(frame, 60 * std::sqrt(0.4), 3) << said;
    // For a demonstration this is expected.
    auto const demonstrated = failuresOf({R"("demonstration": true, )", fallen, pushes});
    EXPECT_TRUE(demonstrated.empty()) << lines(demonstrated);
}

TEST_F(Verify, ReportsADemonstrationThatDoesNotReachItsGoals) {
    std::string const unsolved = R"({"name": "nothing", "expect": "unsolved", "frames": 10})";
    auto const failures = failuresOf({R"("demonstration": true, )", never, unsolved});
    ASSERT_EQ(failures.size(), 1U) << lines(failures);
    EXPECT_NE(failures.front().find("demonstration"), std::string::npos) << failures.front();
    EXPECT_TRUE(failuresOf({"", never, unsolved}).empty());
}

TEST_F(Verify, ReportsMissingGoalsAndSolutions) {
    std::string const said = lines(failuresOf({"", "", ""}));
    EXPECT_NE(said.find("no goals"), std::string::npos) << said;
    EXPECT_NE(said.find("no solution"), std::string::npos) << said;
    EXPECT_EQ(failuresOf({"", pushed, ""}).size(), 1U);
}

TEST_F(Verify, ReportsATaskThatCanNeverBeFulfilledWithItsPlace) {
    auto const failures =
        failuresOf({R"("demonstration": true, "task": {"on": "resting"}, )", fallen, pushes});
    ASSERT_EQ(failures.size(), 1U) << lines(failures);
    EXPECT_NE(failures.front().find(": /task"), std::string::npos) << failures.front();
}

TEST_F(Verify, ReportsWhatCannotBeReadWithItsPlace) {
    auto const unknown = failuresOf({R"("gaols": {}, )", pushed, pushes});
    ASSERT_EQ(unknown.size(), 1U) << lines(unknown);
    EXPECT_NE(unknown.front().find(".json:1:"), std::string::npos) << unknown.front();
    EXPECT_NE(unknown.front().find("'gaols'"), std::string::npos) << unknown.front();
    // A part that the toolbox lacks is found when the solution is loaded.
    auto const lacking =
        failuresOf({"", pushed, R"({"name": "anvil", "placements": [{"part": "crate", "at": [2, 2]}]})"});
    ASSERT_FALSE(lacking.empty());
    EXPECT_NE(lacking.back().find("/solutions/0/placements/0"), std::string::npos) << lacking.back();
    EXPECT_EQ(verifyLevel(gameData(), file_.string() + ".missing").size(), 1U);
}

TEST_F(Verify, TriesTheDetailLevelsThatAreAskedFor) {
    EXPECT_TRUE(failuresOf({"", pushed, pushes}).empty());
    auto const failures = verifyLevel(gameData(), file_, {{"telepathy", "strong"}});
    ASSERT_EQ(failures.size(), 1U) << lines(failures);
    EXPECT_NE(failures.front().find("telepathy"), std::string::npos) << failures.front();
}

} // namespace
} // namespace verify_test
} // namespace trembler
