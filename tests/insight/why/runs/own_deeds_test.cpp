#include "insight/why/runs/own_deeds.hpp"
#include "insight/why/words/words.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/insight/support/tested_level.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace trembler::insight {
namespace own_deeds_test {
namespace {

Answer answerIn(std::string const& file, std::string const& name) {
    LevelFile const level = loadLevel(gameData().registry, testedFile(file));
    Solution const& solution = *level.findSolution(name);
    LevelRuns const runs(gameData(), level);
    AskOptions options;
    options.frames = LevelRuns::framesFor(solution);
    options.threads = 2;
    return why(runs, solution, {}, options);
}

// The doorbell rings by itself, unless the player carries its switch away.
TEST(OwnDeeds, AreToldIfTheGoalIsMetWithoutThem) {
    Answer const answer = answerIn("experiments/2-doorbell.json", "hit the bell with the switch");
    ASSERT_FALSE(answer.happened);
    std::vector<Miss> const& besides = answer.nearest->nearest.besides;
    auto const deed = std::find_if(besides.begin(), besides.end(),
                                   [](Miss const& miss) { return miss.lack == Lack::grab; });
    ASSERT_NE(deed, besides.end());
    EXPECT_EQ(deed->names, std::vector<std::string>{"switch"});
    EXPECT_EQ(deed->ifClosed, IfClosed::met);
    std::string told;
    for (std::string const& sentence : sentencesOf(answer, "Ring", AnswerLanguage())) {
        told += sentence + " ";
    }
    EXPECT_NE(told.find("You took hold of the switch. Without that, the goal would have been met."),
              std::string::npos)
        << told;
    EXPECT_NE(told.find("between copper contact 1 and copper contact 2"), std::string::npos) << told;
    EXPECT_EQ(toJson(answer.nearest->nearest)["besides"].back()["if_gone"], "met");
}

TEST(OwnDeeds, AreNotToldIfTheyChangeNothing) {
    Answer const answer = answerIn("2-electricity/4-one-load-too-many.json", "no hand lifts the rod");
    ASSERT_FALSE(answer.happened);
    std::vector<Miss> const& besides = answer.nearest->nearest.besides;
    EXPECT_TRUE(std::none_of(besides.begin(), besides.end(),
                             [](Miss const& miss) { return miss.lack == Lack::grab; }));
}

} // namespace
} // namespace own_deeds_test
} // namespace trembler::insight
